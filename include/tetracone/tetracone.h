#include "tetracone/tetratree/door/tetracone.h"
