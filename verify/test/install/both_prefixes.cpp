// Installed headers are found under the package's prefix and under the folder's own, and are the same file.
#include <tetracone/kernel/predicate/contact.h>
#include "tetracone/kernel/predicate/contact.h"

int main() { return tetracone::kernel::to_string(tetracone::kernel::Contact::edge_face) == "edge-face" ? 0 : 1; }
