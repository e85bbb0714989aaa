#include "tetracone/tetratree/door/repair.h"
