#include "tetracone/tetratree/scene/scene.h"
