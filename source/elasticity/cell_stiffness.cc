#include <stiction/elasticity/cell_stiffness.h>
#include <cmath>
namespace stiction
{
  static void
  element(const HexahedralCell &c, double *K)
  {
    for (int i = 0; i < 576; ++i)
      K[i] = 0;
    const double g = 1 / std::sqrt(3.);
    for (int q = 0; q < 8; ++q)
      {
        double p[3];
        for (int d = 0; d < 3; ++d)
          p[d] = .5 + .5 * ((q >> d & 1) ? g : -g);
        double G[8][3], J[3][3] = {};
        for (int v = 0; v < 8; ++v)
          for (int d = 0; d < 3; ++d)
            {
              double w = 1;
              for (int e = 0; e < 3; ++e)
                {
                  bool b = v >> e & 1;
                  w *= e == d ? (b ? 1. : -1.) : (b ? p[e] : 1 - p[e]);
                }
              G[v][d] = w;
              for (int a = 0; a < 3; ++a)
                J[a][d] += c.vertices[v][a] * w;
            }
        double inv[3][3];
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b)
            inv[b][a] =
              J[(a + 1) % 3][(b + 1) % 3] * J[(a + 2) % 3][(b + 2) % 3] -
              J[(a + 1) % 3][(b + 2) % 3] * J[(a + 2) % 3][(b + 1) % 3];
        double det =
          J[0][0] * inv[0][0] + J[0][1] * inv[1][0] + J[0][2] * inv[2][0];
        for (auto &r : inv)
          for (double &x : r)
            x /= det;
        double D[8][3];
        for (int v = 0; v < 8; ++v)
          for (int a = 0; a < 3; ++a)
            {
              D[v][a] = 0;
              for (int d = 0; d < 3; ++d)
                D[v][a] += G[v][d] * inv[d][a];
            }
        for (int i = 0; i < 8; ++i)
          for (int j = 0; j < 8; ++j)
            {
              double dd =
                D[i][0] * D[j][0] + D[i][1] * D[j][1] + D[i][2] * D[j][2];
              for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                  K[(3 * i + a) * 24 + 3 * j + b] +=
                    det / 8 *
                    (c.lame_lambda * D[i][a] * D[j][b] +
                     c.shear_modulus * (D[i][b] * D[j][a] + (a == b ? dd : 0)));
            }
      }
  }
  template<typename N>
  CellStiffness<N>::CellStiffness(const std::vector<HexahedralCell> &cells,
                                  InstructionSet)
  {
    const HexahedralCell *last = nullptr;
    for (auto &c : cells)
      {
        nodes_.push_back(c.nodes);
        bool same = last;
        if (same)
          {
            double h = std::abs(c.vertices[7][0] - c.vertices[0][0]);
            for (int v = 0; v < 8; ++v)
              for (int a = 0; a < 3; ++a)
                same = same &&
                       std::abs((c.vertices[v][a] - c.vertices[0][a]) -
                                (last->vertices[v][a] - last->vertices[0][a])) <
                         1e-11 * h;
          }
        if (!same)
          {
            double K[576];
            element(c, K);
            K_.emplace_back();
            for (int i = 0; i < 576; ++i)
              K_.back()[i] = K[i];
            last = &c;
          }
        cls_.push_back(K_.size() - 1);
      }
  }
  template<typename N>
  void
  CellStiffness<N>::add_product(N *dst, const N *src) const
  {
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      {
        N x[24], y[24] = {};
        for (int v = 0; v < 8; ++v)
          for (int a = 0; a < 3; ++a)
            x[3 * v + a] = src[3 * (std::size_t)nodes_[k][v] + a];
        const N *K = K_[cls_[k]].data();
        for (int i = 0; i < 24; ++i)
          for (int j = 0; j < 24; ++j)
            y[j] += K[24 * i + j] * x[i];
        for (int v = 0; v < 8; ++v)
          for (int a = 0; a < 3; ++a)
            dst[3 * (std::size_t)nodes_[k][v] + a] += y[3 * v + a];
      }
  }
  template<typename N>
  void
  CellStiffness<N>::add_diagonal_blocks(N *dst) const
  {
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      {
        const N *K = K_[cls_[k]].data();
        for (int v = 0; v < 8; ++v)
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
              dst[9 * (std::size_t)nodes_[k][v] + 3 * a + b] +=
                K[(3 * v + a) * 24 + 3 * v + b];
      }
  }
  template class CellStiffness<float>;
  template class CellStiffness<double>;
} // namespace stiction
