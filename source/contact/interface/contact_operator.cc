#include <stiction/contact/interface/contact_operator.h>
#include <stiction/qp/operators/nodal_blocks.h>

#include <deal.II/lac/la_parallel_vector.h>

#include <algorithm>
#include <utility>

namespace stiction
{
  namespace
  {
    // The same map at every node.
    template<typename Map>
    Eigen::VectorXd at_all_nodes(const std::vector<ContactFrame> &frames,
                                 const Eigen::VectorXd &v, const Map &map)
    {
      Eigen::VectorXd image(v.size());
      for (std::size_t i = 0; i < frames.size(); ++i)
        {
          const auto k = static_cast<Eigen::Index>(i);
          set_at_node(image, k, (frames[i].*map)(at_node(v, k)));
        }
      return image;
    }
  } // namespace

  ContactOperator::ContactOperator(DofSubset dofs, std::vector<ContactFrame> frames)
    : dofs_(std::move(dofs))
    , frames_(std::move(frames))
  {
  }

  bool ContactOperator::operator==(const ContactOperator &other) const
  {
    return dofs_.dofs() == other.dofs_.dofs() &&
           std::equal(frames_.begin(), frames_.end(), other.frames_.begin(),
                      [](const ContactFrame &a, const ContactFrame &b) {
                        return a.axes() == b.axes() && a.scale == b.scale;
                      });
  }

  Eigen::VectorXd ContactOperator::apply(const LA::Vector &u) const
  {
    return at_all_nodes(frames_, dofs_.restriction(u),
                        &ContactFrame::displacement_to_local);
  }

  void ContactOperator::add_transpose(const double factor, const Eigen::VectorXd &lambda,
                                      LA::Vector &dst) const
  {
    dofs_.add_extension(factor * force_to_cartesian(lambda), dst);
  }

  void ContactOperator::set_transpose(const Eigen::VectorXd &lambda,
                                      LA::Vector &dst) const
  {
    for (const auto dof : dofs_.dofs())
      if (dst.in_local_range(dof))
        dst(dof) = 0.;
    dofs_.add_extension(force_to_cartesian(lambda), dst);
  }

  void ContactOperator::add_displacement(const double factor, const Eigen::VectorXd &w,
                                         LA::Vector &u) const
  {
    dofs_.add_extension(
      factor * at_all_nodes(frames_, w, &ContactFrame::displacement_to_cartesian), u);
  }

  Eigen::VectorXd ContactOperator::contact_forces(const LA::Vector &R) const
  {
    return force_to_local(dofs_.restriction(R));
  }

  Eigen::VectorXd ContactOperator::force_to_cartesian(const Eigen::VectorXd &lambda) const
  {
    return at_all_nodes(frames_, lambda, &ContactFrame::force_to_cartesian);
  }

  Eigen::VectorXd ContactOperator::force_to_local(const Eigen::VectorXd &force) const
  {
    return at_all_nodes(frames_, force, &ContactFrame::force_to_local);
  }

  void ContactOperator::rotate_to_local(Eigen::MatrixXd &C) const
  {
    const Eigen::Index m = n_nodes();
    std::vector<Eigen::Matrix3d> M;
    for (const ContactFrame &frame : frames_)
      M.push_back(frame.scales().asDiagonal() * frame.axes());
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
    Eigen::VectorXd held(3 * n_nodes());
    for (Eigen::Index i = 0; i < n_nodes(); ++i)
      set_at_node(held, i, (frames_[i].scales().array() == 0.).matrix().cast<double>());
    return held;
  }
} // namespace stiction
