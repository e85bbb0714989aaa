// The templates' installed headers are found in angle brackets and in quotes, and are the same file.
#include <tetracone/kernel/predicate/contact.h>
#include "tetracone/kernel/predicate/contact.h"

int main() { return tetracone::kernel::to_string(tetracone::kernel::Contact::edge_face) == "edge-face" ? 0 : 1; }
