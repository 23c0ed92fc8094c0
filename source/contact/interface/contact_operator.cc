#include <stiction/contact/interface/contact_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace stiction
{
  namespace
  {
    // Of the largest displacement of a rigid motion.
    constexpr double rounding_of_motion = 1e-10;

    // The same map at every node.
    template<typename Map>
    Eigen::VectorXd at_all_nodes(const std::vector<ContactFrame> &frames,
                                 const Eigen::VectorXd &v, const Map &map)
    {
      return by_nodes(v.size() / 3, [&](const Eigen::Index i) {
        return (frames[i].*map)(at_node(v, i));
      });
    }

    // Of forces on contact nodes, or displacements, by blocks, what is their own.
    Eigen::VectorXd own_parts(const std::vector<ContactFrame> &frames,
                              const Eigen::VectorXd &v)
    {
      return by_nodes(v.size() / 3, [&](const Eigen::Index i) -> Eigen::Vector3d {
        return frames[i].own_part * at_node(v, i);
      });
    }

    // All, of what is their own.
    Eigen::VectorXd from_own_parts(const std::vector<ContactFrame> &frames,
                                   const Eigen::VectorXd &v)
    {
      return by_nodes(v.size() / 3, [&](const Eigen::Index i) -> Eigen::Vector3d {
        return at_node(v, i) / frames[i].own_part;
      });
    }

    bool are_same(const ContactFrame &a, const ContactFrame &b)
    {
      return a.normal == b.normal && a.axes() == b.axes() && a.scale == b.scale;
    }

    // Whether two sparse matrices have the same entries, bit by bit.
    bool are_equal(const Eigen::SparseMatrix<double, Eigen::RowMajor> &a,
                   const Eigen::SparseMatrix<double, Eigen::RowMajor> &b)
    {
      return a.rows() == b.rows() && a.cols() == b.cols() &&
             a.nonZeros() == b.nonZeros() &&
             std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr()) &&
             std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(),
                        b.innerIndexPtr());
    }
  } // namespace

  ContactOperator::ContactOperator(DofSubset dofs, std::vector<ContactFrame> frames,
                                   OtherSide other)
    : dofs_(std::move(dofs))
    , frames_(std::move(frames))
    , other_(std::move(other))
  {
  }

  DofSubset ContactOperator::all_dofs() const
  {
    auto all = dofs_.dofs();
    const std::set<dealii::types::global_dof_index> own(all.begin(), all.end());
    for (const auto dof : other_.dofs.dofs())
      if (own.count(dof) == 0)
        all.push_back(dof);
    return DofSubset(std::move(all));
  }

  bool ContactOperator::has_nodes_of(const ContactOperator &other) const
  {
    return dofs_.dofs() == other.dofs_.dofs() &&
           other_.dofs.dofs() == other.other_.dofs.dofs() &&
           are_equal(other_.A, other.other_.A);
  }

  bool ContactOperator::operator==(const ContactOperator &other) const
  {
    return has_nodes_of(other) &&
           std::equal(frames_.begin(), frames_.end(), other.frames_.begin(), are_same);
  }

  bool ContactOperator::is_turned(const ContactOperator &other) const
  {
    return has_nodes_of(other) &&
           std::equal(frames_.begin(), frames_.end(), other.frames_.begin(),
                      [this](const ContactFrame &a, const ContactFrame &b) {
                        // held directions are part of the basis in which others are
                        // opposite
                        return are_same(a, b) ||
                               (a.prescribed == b.prescribed &&
                                !(a.is_held() && has_other_side()) &&
                                (a.scale[0] == 0.) == (b.scale[0] == 0.) &&
                                (a.scale[1] == 0.) == (b.scale[1] == 0.));
                      });
  }

  Eigen::VectorXd ContactOperator::apply(const LA::Vector &u) const
  {
    return at_all_nodes(frames_, relative_displacement(u),
                        &ContactFrame::displacement_to_local);
  }

  Eigen::VectorXd ContactOperator::apply_to_motion(const LA::Vector &u) const
  {
    const Eigen::VectorXd w = apply(u);
    return (w.array().abs() > rounding_of_motion * u.linfty_norm()).select(w, 0.);
  }

  Eigen::VectorXd ContactOperator::relative_displacement(const LA::Vector &u) const
  {
    Eigen::VectorXd relative = own_parts(frames_, dofs_.restriction(u));
    if (has_other_side())
      relative -= other_.A * other_.dofs.restriction(u);
    return relative;
  }

  Eigen::VectorXd ContactOperator::free_forces(const Eigen::VectorXd &lambda) const
  {
    return own_parts(frames_, at_all_nodes(frames_, force_to_cartesian(lambda),
                                           &ContactFrame::in_free_directions));
  }

  Eigen::VectorXd ContactOperator::forces_on_other_side(
    const Eigen::VectorXd &lambda) const
  {
    return -other_.A.transpose() * force_to_cartesian(lambda);
  }

  void ContactOperator::add_transpose(const double factor, const Eigen::VectorXd &lambda,
                                      LA::Vector &dst) const
  {
    dofs_.add_extension(factor * own_parts(frames_, force_to_cartesian(lambda)), dst);
    if (has_other_side())
      other_.dofs.add_extension(factor * forces_on_other_side(lambda), dst);
  }

  void ContactOperator::add_load(const double factor, const Eigen::VectorXd &lambda,
                                 LA::Vector &dst) const
  {
    dofs_.add_extension(factor * free_forces(lambda), dst);
    if (has_other_side())
      other_.dofs.add_extension(
        factor * forces_on_other_side(lambda).cwiseProduct(other_.is_free), dst);
  }

  void ContactOperator::set_transpose(const Eigen::VectorXd &lambda,
                                      LA::Vector &dst) const
  {
    for (const auto dof : dofs_.dofs())
      if (dst.in_local_range(dof))
        dst(dof) = 0.;
    dofs_.add_extension(free_forces(lambda), dst);
  }

  void ContactOperator::add_displacement(const double factor, const Eigen::VectorXd &w,
                                         LA::Vector &u) const
  {
    dofs_.add_extension(
      factor *
        from_own_parts(
          frames_, at_all_nodes(frames_, w, &ContactFrame::displacement_to_cartesian)),
      u);
  }

  Eigen::VectorXd ContactOperator::contact_forces(const LA::Vector &R) const
  {
    return from_own_parts(frames_, force_to_local(dofs_.restriction(R)));
  }

  Eigen::VectorXd ContactOperator::force_to_cartesian(const Eigen::VectorXd &lambda) const
  {
    return at_all_nodes(frames_, lambda, &ContactFrame::force_to_cartesian);
  }

  Eigen::VectorXd ContactOperator::force_to_local(const Eigen::VectorXd &force) const
  {
    return at_all_nodes(frames_, force, &ContactFrame::force_to_local);
  }

  Eigen::MatrixXd ContactOperator::compliance(Eigen::MatrixXd C) const
  {
    if (!has_other_side())
      {
        rotate_to_local(C);
        return C;
      }
    const Eigen::Index m = n_nodes();
    const auto all       = all_dofs().dofs();
    std::map<dealii::types::global_dof_index, Eigen::Index> column;
    for (std::size_t j = 0; j < all.size(); ++j)
      column[all[j]] = static_cast<Eigen::Index>(j);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < m; ++i)
      for (Eigen::Index c = 0; c < 3; ++c)
        {
          const ContactFrame &frame  = frames_[i];
          const Eigen::Vector3d unit = Eigen::Vector3d::Unit(c);
          const Eigen::Vector3d own =
            frame.own_part * frame.displacement_to_local(frame.in_free_directions(unit));
          const Eigen::Vector3d of_other = frame.displacement_to_local(unit);
          for (Eigen::Index r = 0; r < 3; ++r)
            {
              entries.emplace_back(i + r * m, i + c * m, own(r));
              for (decltype(other_.A)::InnerIterator a(other_.A, i + c * m); a; ++a)
                entries.emplace_back(i + r * m, column.at(other_.dofs.dofs()[a.col()]),
                                     -of_other(r) * a.value() * other_.is_free(a.col()));
            }
        }
    Eigen::SparseMatrix<double, Eigen::RowMajor> B(3 * m, C.rows());
    B.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXd BC = B * C;
    return B * BC.transpose();
  }

  void ContactOperator::rotate_to_local(Eigen::MatrixXd &C) const
  {
    const Eigen::Index m = n_nodes();
    std::vector<Eigen::Matrix3d> M;
    for (const ContactFrame &frame : frames_)
      M.emplace_back(frame.own_part * frame.scales().asDiagonal() * frame.axes());
    for (Eigen::Index j = 0; j < m; ++j)
      for (Eigen::Index i = 0; i < m; ++i)
        {
          Eigen::Matrix3d block;
          for (Eigen::Index b = 0; b < 3; ++b)
            for (Eigen::Index a = 0; a < 3; ++a)
              block(a, b) = C(i + a * m, j + b * m);
          block = (M[i] * block * M[j].transpose()).eval();
          for (Eigen::Index b = 0; b < 3; ++b)
            for (Eigen::Index a = 0; a < 3; ++a)
              C(i + a * m, j + b * m) = block(a, b);
        }
  }

  Eigen::VectorXd ContactOperator::held() const
  {
    return by_nodes(n_nodes(), [&](const Eigen::Index i) -> Eigen::Vector3d {
      return (frames_[i].scales().array() == 0.).matrix().cast<double>();
    });
  }
} // namespace stiction
