#pragma once

#include <stiction/base/text/parameter_file.h>
#include <stiction/contact/dual/contact_solver_parameters.h>
#include <stiction/contact/dual/dual_operator_parameters.h>
#include <stiction/contact/interface/contact_pair_parameters.h>
#include <stiction/contact/interface/friction_parameters.h>
#include <stiction/elasticity/mesh/geometry_parameters.h>
#include <stiction/elasticity/mesh/refinement_parameters.h>
#include <stiction/elasticity/model/body_parameters.h>
#include <stiction/elasticity/model/boundary_parameters.h>
#include <stiction/elasticity/model/material_parameters.h>
#include <stiction/elasticity/solvers/stiffness_solver_parameters.h>
#include <stiction/output/output_parameters.h>
#include <stiction/simulation/parameters/performance_parameters.h>
#include <stiction/simulation/parameters/time_parameters.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stiction
{
  /// All that a user can set. Filled once by read(), constant afterwards. What
  /// decides the problem (body, material, supports, loads, contact, friction)
  /// has no default: it is empty until the user says it, and
  /// require_complete() misses it.
  ///
  /// Each section stands in the room that uses it, with its entries and with the
  /// checks that concern it alone.
  ///
  /// The sections declare their entries in deal.II's global ParameterHandler,
  /// which belongs to the Parameters object made last: read() an object before
  /// making another.
  class Parameters
  {
  private:
    /// Empties the global ParameterHandler before the sections fill it.
    struct Reset
    {
      Reset();
    } reset_;

  public:
    /// Reads a file and command line settings and checks every value.
    ///
    /// @param file may be empty: all defaults.
    /// @param output, export_directory the arguments of --output and --export,
    ///   which go before all else.
    /// @param has_body whether the values that describe a body count, and are
    ///   checked.
    ///
    /// Throws InputError: see ParameterFile::read() and check_body().
    void read(const std::string &file, const std::vector<std::string> &settings = {},
              const std::optional<std::string> &output           = std::nullopt,
              const std::optional<std::string> &export_directory = std::nullopt,
              bool has_body                                      = true);

    /// Throws InputError if the method cannot solve a problem with this law.
    void check_method(bool is_coulomb) const;

    /// See MaterialParameters::has_mean_dilatation().
    bool has_mean_dilatation() const { return material.has_mean_dilatation(); }

    /// Whether the elements lock: trilinear ones, a Poisson ratio near 0.5 and
    /// 'Volume strain = pointwise'.
    bool has_locking() const
    {
      return geometry.element_degree == 1 && !has_mean_dilatation() &&
             material.largest_poisson_ratio() > MaterialParameters::locking_poisson_ratio;
    }

    /// 'Stiffness solver/Type', with automatic replaced by what it stands for.
    std::string stiffness_solver_type() const;

    /// Whether the solver works without a stiffness matrix on the levels.
    bool is_matrix_free() const { return stiffness_solver_type() == "multigrid"; }

    /// What to choose where what is in use comes no closer, of what is neither in
    /// use nor refused beside the other entries: "choose 'Contact solver/Method =
    /// newton' or 'newton multigrid'".
    ///
    /// @param is_coulomb whether there is Coulomb friction. @param has_body
    ///   whether there is a body, not Q and h alone. @param tried what is in use, none:
    ///   'Contact solver/Method'.
    std::string advice_on_method(bool is_coulomb, bool has_body,
                                 std::set<std::string> tried = {}) const;

    /// What the rooms of the body and of contact are told of all this, which must
    /// outlive it.
    BodyParameters of_body() const
    {
      return {material, boundary, source, time.times().front()};
    }
    ContactParameters of_contact() const { return {contact, friction, source}; }

    /// The complete commented default file, in declaration order.
    static std::string default_file();

    /// The values in use, as a parameter file.
    const std::string &used_file() const { return used_file_; }

    GeometryParameters geometry;
    RefinementParameters refinement;
    MaterialParameters material;
    BoundaryParameters boundary;
    ContactPairParameters contact;
    TimeParameters time;
    FrictionParameters friction;
    ContactSolverParameters contact_solver; ///< its method never automatic once read
    StiffnessSolverParameters stiffness_solver;
    DualOperatorParameters dual_operator;
    OutputParameters output;
    PerformanceParameters performance;

    /// Where the values came from, for messages.
    ParameterFile source;

  private:
    /// Whether the entries of all sections go together. Throws InputError.
    void check_body() const;

    /// By names or numbers, as they stand in entries.
    std::set<std::string> boundaries_in_use() const;

    /// The part of it about a row of Table 1, which wants its own boundaries.
    void check_table_1() const;

    /// The part of it about solvers that need each other.
    void check_solvers() const;

    /// Whether another method than the chosen one is refused beside the other
    /// entries.
    bool is_refused(const std::string &method, bool has_body) const;

    std::string used_file_;
  };
} // namespace stiction
