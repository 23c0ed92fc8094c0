#pragma once

#include <stiction/base/text/boundary_functions.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/base/tensor.h>

#include <map>
#include <memory>

namespace stiction
{
  class Body;
  class Materials;
  struct BodyParameters;
  class PrescribedDisplacement;

  /// The given forces on a body: tractions and pressures on its boundaries,
  /// body force and weight inside,
  ///
  /// f_i = ∫_Γ (t − p n)·φ_i + ∫_Ω (b + ρ g)·φ_i.
  class Loads
  {
  public:
    /// @param time the value of t.
    ///
    /// Throws InputError for entries that cannot be read, and for a load on a
    /// boundary that is held in all components.
    Loads(const Body &body, const PrescribedDisplacement &prescribed,
          const BodyParameters &parameters, double time);
    ~Loads();

    /// Adds the nodal forces, at prescribed unknowns too, to a vector that can
    /// take those of all nodes of the own cells, and sums up what the ranks
    /// have. Unit: N. Collective.
    ///
    /// Throws InputError if a formula has no finite value.
    void assemble(const Materials &materials, LA::Vector &load) const;

    /// The traction t − p n on a boundary, whose outward normal is n. Unit: Pa.
    dealii::Tensor<1, 3> traction(dealii::types::boundary_id boundary,
                                  const dealii::Point<3> &x,
                                  const dealii::Tensor<1, 3> &normal) const;

    /// What is said to load a boundary, for people: "traction 0; 0; -1e8,
    /// pressure 1e6"; "" if nothing is.
    std::string description(dealii::types::boundary_id boundary) const;

    /// The same of the inside of the body: "gravity 0; 0; -9.81".
    std::string description_inside() const;

    /// The force b + ρ g at a place inside the body with this density ρ. Unit:
    /// N/m³.
    dealii::Tensor<1, 3> inside(double density, const dealii::Point<3> &x) const;

    /// A boundary's area (m²) and the resultant of its loads (N).
    struct OnBoundary
    {
      double area = 0.;
      dealii::Tensor<1, 3> force;
    };

    /// Of all boundaries of the mesh. Collective.
    std::map<dealii::types::boundary_id, OnBoundary> on_boundaries() const;

  private:
    void add_boundary_loads(LA::Vector &load) const;

    void add_volume_loads(const Materials &materials, LA::Vector &load) const;

    const Body &body_;
    BoundaryFunctions traction_, pressure_;
    std::unique_ptr<ParsedFunction> body_force_, gravity_; ///< null: none
  };
} // namespace stiction
