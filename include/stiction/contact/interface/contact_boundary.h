#pragma once

#include <stiction/base/text/numbers.h>
#include <stiction/contact/pairs/slave_side.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace stiction
{
  class Body;
  struct ContactNode;
  struct ContactParameters;
  class FrictionData;
  class Obstacle;
  class ParsedFunction;
  class ParameterFile;

  /// What the user says of one contact boundary: what it may touch, at which
  /// distance, and how it rubs there.
  class ContactBoundary
  {
  public:
    /// All contact boundaries, in the order of the parameter file. Collective.
    ///
    /// @param time the value of t.
    ///
    /// Throws InputError for a boundary that the mesh does not have or that
    /// stands twice, for entries with neither one value nor one a boundary, and
    /// for values that cannot be read.
    static std::vector<ContactBoundary> read(const ContactParameters &parameters,
                                             const Body &body, double time);

    ContactBoundary(ContactBoundary &&) noexcept;
    ~ContactBoundary();

    dealii::types::boundary_id id() const { return id_; }

    /// As the user calls it.
    const std::string &name() const { return name_; }

    /// NAME of its section 'Contact pair NAME'; "" if it has no such section.
    const std::string &section_name() const { return section_name_; }

    /// For people: "top", "top against bottom", or "NAME: top against bottom".
    std::string title() const;

    /// What the entries say of it, for people: "foundation, gap 1e-5, Coulomb
    /// friction, F = 0.3".
    const std::string &description() const { return description_; }

    /// How far the obstacle is moved from where it is said to be, m.
    const dealii::Tensor<1, 3> &displacement() const { return displacement_; }

    /// The axis a, a unit vector, about which its surface turns; zero: about none.
    const dealii::Tensor<1, 3> &axis() const { return axis_; }

    /// θ, by which it has turned about that axis, rad.
    double angle() const { return angle_; }

    /// a × (x − p), p being a point of the axis, m: times θ it is by how much the
    /// surface of an obstacle that turns has moved along itself at its point x with
    /// the normal n.
    ///
    /// Throws InputError if it turns and this is not along the surface, so that the
    /// obstacle is no body of revolution about the axis.
    dealii::Tensor<1, 3> arm(const dealii::Point<3> &x,
                             const dealii::Tensor<1, 3> &n) const;

    /// The force in N that presses the obstacle on and along which it is free
    /// to move; zero: it is held.
    const dealii::Tensor<1, 3> &force() const { return force_; }

    /// What the parameter file says of it, for messages.
    const ParameterFile &source() const { return *source_; }

    /// What it may touch, where the parameter file puts it; nullptr: the
    /// foundation.
    const Obstacle *obstacle() const { return obstacle_.get(); }

    /// Whether it is the slave of a contact pair: what it may touch is another boundary.
    bool is_pair() const { return !partners_.empty(); }

    /// The masters of the pair, and what they are called, separated by commas.
    const std::vector<dealii::types::boundary_id> &partners() const { return partners_; }
    const std::string &partner_name() const { return partner_name_; }

    bool has_partner(dealii::types::boundary_id id) const;

    /// The places in Body::pieces() of the bodies that have it or one of the partners.
    std::set<unsigned int> pieces(const Body &body) const;

    /// "automatic", "boundary" or "obstacle".
    const std::string &slave_side() const { return slave_side_; }

    /// Whether it and its partner are one body: they neither open nor slip from where
    /// they are meshed.
    bool is_tied() const;

    /// Whether gaps and normals are those where body and obstacle come to, not those
    /// where the body is made.
    bool slides_far() const { return sliding_ == "far"; }

    /// Whether the distance of the meshes of a pair is part of the gap.
    bool keeps_mesh_gap() const { return mesh_gap_ == "kept"; }

    /// Makes it the slave of a pair, after exchanging the sides if it is not yet.
    void take_side(const SlaveSide &side);

    /// That which bears the forces of a pair, the first one of the parameter file to
    /// begin with.
    const SlaveSide &side() const { return side_; }

    /// Whether pressures on such a side waver. Of a tie, a linear problem, the first
    /// Newton step is the last one all the same.
    bool wavers(const SlaveSide &side) const { return side.wavers() && !is_tied(); }

    /// Whether the other side is one boundary, on which pressures would not waver.
    bool other_side_may_bear() const
    {
      return partners_.size() == 1 && !wavers(side_.other(""));
    }

    /// The value of 'Initial gap' at a place, by which the obstacle is farther
    /// away than its own surface. Throws InputError if it has none.
    double initial_gap(const dealii::Point<3> &p) const;

    /// Whether that depends on the place.
    bool has_gap_of_places() const { return has_variable(gap_text_, "xyz"); }

    /// That of the body, m: no obstacle may be deeper in it.
    double body_size() const { return size_; }

    /// Gives a node of this boundary, whose normal is the outward one, its gap
    /// and the normal towards the obstacle n = −∇ψ/‖∇ψ‖ where it has moved: the
    /// linearisation of ψ(x + u − U) ≥ 0.
    ///
    /// @return whether the node can touch the obstacle: a node whose outward
    ///   normal has a cosine below 0.1 with n faces away from it.
    ///
    /// Throws InputError if ∇ψ = 0, and if the obstacle is deeper in the body than
    /// the body is large.
    bool place(ContactNode &node) const;

    /// place(), with the gap of a node that is too deep in the obstacle, or where this
    /// has no normal.
    void place_if_possible(ContactNode &node) const;

    /// Throws InputError if a node that was placed, and faces away, is inside the
    /// obstacle.
    void require_outside(const ContactNode &node) const;

    const FrictionData &friction() const { return *friction_; }

    /// How far a place is inside the obstacle along ∇ψ, which 'Initial gap' makes
    /// smaller, m; 0 outside and for the foundation.
    double penetration(const dealii::Point<3> &p) const;

  private:
    struct Entries;
    static std::vector<Entries> entries_of(const ContactParameters &parameters);

    ContactBoundary(const Entries &entries, ParameterFile source, const Body &body,
                    double time);

    /// Makes description_ and, without what may be touched, details_.
    void describe(const Entries &entries);

    /// Throws InputError unless there is another side, and no gap.
    void require_tied_pair(bool has_partners, const std::string &gap) const;

    /// Throws InputError if an entry has another value.
    void require_one_of(const std::string &entry, const std::string &value,
                        const std::vector<std::string> &allowed) const;

    /// Makes it one side of a pair. Throws InputError if the mesh has no such other
    /// boundaries, or if the pair is said to move.
    void pair_with(const std::vector<std::string> &others, const Body &body);

    /// From 'px; py; pz; ax; ay; az; angle'. Throws InputError if the axis is zero.
    void set_rotation(const std::vector<double> &numbers);

    std::string name_, section_name_, description_, details_, partner_name_, slave_side_,
      mesh_gap_, sliding_, gap_text_;
    dealii::types::boundary_id id_ = dealii::numbers::invalid_boundary_id;
    SlaveSide side_{true, 1., 1., ""};
    std::vector<dealii::types::boundary_id> partners_;

    std::unique_ptr<Obstacle> obstacle_; ///< none: the foundation
    std::unique_ptr<ParsedFunction> gap_;
    std::unique_ptr<FrictionData> friction_;
    dealii::Tensor<1, 3> displacement_, force_, axis_;
    dealii::Point<3> axis_point_;
    double angle_ = 0.; ///< rad
    double size_  = 0.; ///< of the body, m
    std::shared_ptr<const ParameterFile> source_;
  };
} // namespace stiction
