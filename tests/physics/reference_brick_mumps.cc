// The reference brick on the first three rows of Table 1, both laws: the
// contact force and the numbers of open, slipping and sticking nodes that two
// independent programs agree on. Here with a factorisation.

#define STIFFNESS_SOLVER "mumps"
#define LARGEST_LEVEL 3
#include "reference_brick.h"
