// Formulas with && and ||, with blanks around them and without.

#include "tests.h"

#include <stiction/base/text/boundary_functions.h>

using namespace stiction;

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const std::string formula :
       {"if(x<1&&y<1,2,3)", "if(x < 1 && y < 1, 2, 3)", "if(x<1||y<1,2,3)",
        "if(x < 1 || y < 1, 2, 3)", "2*(x<1||y<1&&z<1)"})
    {
      const ParsedFunction f(formula, 1, "f");
      out() << formula << ':';
      for (const double x : {0., 2.})
        for (const double y : {0., 2.})
          out() << ' ' << f.value({x, y, 2.}, 0);
      out() << std::endl;
    }
}
