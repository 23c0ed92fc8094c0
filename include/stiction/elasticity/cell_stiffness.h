#ifndef S_CS
#define S_CS
#include <stiction/elasticity/instruction_set.h>
#include <array>
#include <cstddef>
#include <vector>
namespace stiction
{
  struct HexahedralCell
  {
    std::array<unsigned int, 8> nodes;
    std::array<std::array<double, 3>, 8> vertices;
    double lame_lambda, shear_modulus;
  };
  template<typename Number>
  class CellStiffness
  {
  public:
    explicit CellStiffness(const std::vector<HexahedralCell> &,
                           InstructionSet = best_instruction_set());
    void
    add_product(Number *, const Number *) const;
    void
    add_diagonal_blocks(Number *) const;

  private:
    std::vector<std::array<unsigned, 8>> nodes_;
    std::vector<unsigned> cls_;
    std::vector<std::array<Number, 576>> K_;
  };
} // namespace stiction
#endif
