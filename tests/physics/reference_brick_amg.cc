// The reference brick on the first two rows of Table 1, both laws: the contact
// force and the numbers of open, slipping and sticking nodes that two
// independent programs agree on. Here with conjugate gradients and multigrid;
// newton_multigrid has them on the third row, where Q takes 1134 solves.

#define STIFFNESS_SOLVER "amg"
#define LARGEST_LEVEL 2
#include "reference_brick.h"
