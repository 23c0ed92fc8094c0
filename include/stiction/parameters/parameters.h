#ifndef stiction_parameters_parameters_h
#define stiction_parameters_parameters_h

#include <stiction/parameters/parameter_file.h>

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <string>
#include <vector>

namespace stiction
{
  /// How friction limits the tangential contact force at a node.
  enum class FrictionLaw
  {
    frictionless, ///< g = 0
    given,        ///< g = area × slip stress, also where the node is open
    coulomb       ///< g = F λ_ν
  };

  /// One struct a section of the parameter file; what an entry means stands in
  /// its documentation string, which --print-parameters shows.
  struct GeometryParameters : dealii::ParameterAcceptor
  {
    GeometryParameters();

    /// Unknowns are numbered with 32 bits, in Trilinos and in MUMPS.
    static constexpr double max_cells = 4e8;

    bool is_brick() const { return type == "brick"; }

    /// Number of cells after refinement; a double, because it may be anything
    /// before it is checked. For bodies other than the brick the least
    /// possible: the cells that their coarse mesh has are known only when it
    /// is there.
    /// Of local refinement the most it can make.
    double n_cells() const;

    /// Of them those of the mesh without local refinement.
    double n_uniform_cells() const;

    /// Whether all cells are alike and trilinear, see Body::has_geometric_levels().
    bool has_geometric_levels() const
    {
      return contact_refinement == 0 && element_degree == 1;
    }

    /// The entry ("Section/Entry") to blame if these are too many.
    std::string entry_of_size() const;

    /// The entry that says what the body is: the type, the generator or the
    /// file.
    std::string entry_of_shape() const;

    std::string type                       = "";
    std::vector<double> lengths            = {};
    std::vector<unsigned int> subdivisions = {};
    std::optional<double> radius, length;
    std::string generator                = "";
    std::string generator_arguments      = "";
    std::string mesh_file                = "";
    unsigned int global_refinement       = 0;
    unsigned int contact_refinement      = 0;
    std::string contact_refinement_where = "1";
    unsigned int element_degree          = 1;
    unsigned int table_1_level           = 0;
    std::string table_1_reading          = "nodes";

    /// The beginning of a sentence about entry_of_shape() and its value; read()
    /// of Parameters fills it.
    std::string location = "Geometry";
  };

  struct MaterialParameters : dealii::ParameterAcceptor
  {
    MaterialParameters();

    /// Of all isotropic materials.
    double largest_poisson_ratio() const;

    /// Whether volume strains are means over cells, by 'Volume strain' with
    /// automatic replaced by what it stands for.
    bool has_mean_dilatation(unsigned int element_degree) const;

    /// Above it trilinear elements with pointwise volume strains are much too
    /// stiff.
    static constexpr double locking_poisson_ratio = 0.45;

    std::optional<double> youngs_modulus, poisson_ratio, density;
    std::string materials     = "";
    std::string densities     = "";
    std::string material_ids  = "";
    std::string volume_strain = "automatic";
  };

  struct RefinementParameters : dealii::ParameterAcceptor
  {
    RefinementParameters();

    unsigned int adaptive_steps   = 0;
    double fraction               = 0.5;
    unsigned int maximum_unknowns = 0;
    bool estimate_error           = true;
  };

  struct BoundaryParameters : dealii::ParameterAcceptor
  {
    BoundaryParameters();

    /// Whether an entry moves or loads the body: a force (also one of zero, if
    /// it is written), a displacement that is not zero, an obstacle that is
    /// displaced or pressed on. Interference does so too, which only the gaps
    /// show.
    bool has_load() const;

    /// Whether forces press obstacles on.
    bool has_pressed_obstacles() const;

    std::string prescribed_displacement = "";
    std::string prescribed_points       = "";
    std::string traction                = "";
    std::string pressure                = "";
    std::string body_force              = "";
    std::string gravity                 = "";
    double time                         = 1.;
    std::string contact_boundary        = "";
    std::string obstacle                = "foundation";
    std::string initial_gap             = "0";
    std::string obstacle_displacement   = "0; 0; 0";
    std::string obstacle_force          = "0; 0; 0";
  };

  struct FrictionParameters : dealii::ParameterAcceptor
  {
    FrictionParameters();

    /// The entry Law as values: one, or one a contact boundary.
    std::vector<FrictionLaw> laws() const;

    /// Whether Coulomb's law holds on a contact boundary.
    bool has_coulomb() const;

    /// The one law of all contact boundaries as in the entry, or 'mixed'.
    std::string name() const;

    std::string law_name        = "";
    std::string coefficient     = "";
    std::string slip_stress     = "";
    std::string first_direction = "";
  };

  struct ContactSolverParameters : dealii::ParameterAcceptor
  {
    ContactSolverParameters();

    /// Whether the method solves for displacements, not for contact forces.
    bool is_primal() const;

    std::string method              = "newton";
    double tolerance                = 1e-6;
    unsigned int maximum_iterations = 1000;
    std::string disc_solver         = "newton";
    unsigned int squares            = 2;
    std::string coulomb_iteration   = "direct";
  };

  struct StiffnessSolverParameters : dealii::ParameterAcceptor
  {
    StiffnessSolverParameters();

    std::string type = "automatic";
  };

  struct DualOperatorParameters : dealii::ParameterAcceptor
  {
    DualOperatorParameters();

    std::string form    = "assembled";
    bool symmetric_part = false; ///< of a problem from a file
  };

  struct OutputParameters : dealii::ParameterAcceptor
  {
    OutputParameters();

    /// Whether solution.pvtu gets the fields that can be left out.
    bool has_all_fields() const { return fields == "all"; }

    std::string directory        = "output/stiction";
    std::string export_directory = "";
    std::string units            = "none";
    bool write_solution          = true;
    std::string fields           = "all";
    bool double_precision        = false;
    bool print_progress          = true;
  };

  struct PerformanceParameters : dealii::ParameterAcceptor
  {
    PerformanceParameters();

    bool measure_one_elastic_solve = false;
    bool measure_factorizations    = false;
    bool print_timing              = true;
  };

  /// All that a user can set. Filled once by read(), constant afterwards. What
  /// decides the problem (body, material, supports, loads, contact, friction)
  /// has no default: it is empty until the user says it, and
  /// require_complete() misses it.
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

    /// Whether K can be known cell by cell, without a matrix, and there is
    /// geometric multigrid: a mesh of trilinear cells of isotropic materials
    /// that stays uniform.
    bool has_geometric_levels() const { return why_no_geometric_levels().empty(); }

    /// The entries because of which it is not, with their values, separated by
    /// commas.
    std::string why_no_geometric_levels() const;

    /// See MaterialParameters::has_mean_dilatation().
    bool has_mean_dilatation() const
    {
      return material.has_mean_dilatation(geometry.element_degree);
    }

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
    bool is_matrix_free() const;

    /// Whether a stiffness matrix of the whole mesh is wanted: the Newton
    /// method in displacements makes its own where it needs one.
    bool needs_stiffness_matrix() const;

    /// The complete commented default file, in declaration order.
    static std::string default_file();

    /// The values in use, as a parameter file.
    const std::string &used_file() const { return used_file_; }

    GeometryParameters geometry;
    RefinementParameters refinement;
    MaterialParameters material;
    BoundaryParameters boundary;
    FrictionParameters friction;
    ContactSolverParameters contact_solver;
    StiffnessSolverParameters stiffness_solver;
    DualOperatorParameters dual_operator;
    OutputParameters output;
    PerformanceParameters performance;

    /// Where the values came from, for messages.
    ParameterFile source;

  private:
    /// What a pattern alone cannot see: open ranges, entries that need each
    /// other. Throws InputError.
    void check_body() const;

    /// The part of it about the shape and size of the body.
    void check_geometry() const;

    /// The part of it about the shape that was not said.
    void require_shape() const;

    /// The part of it about a row of Table 1, which wants its own boundaries.
    void check_table_1() const;

    /// The part of it about solvers that need each other.
    void check_solvers() const;

    /// Throws InputError about the entry unless the condition holds.
    void require(bool condition, const std::string &entry,
                 const std::string &allowed) const;

    /// Puts Lengths, Subdivisions and Global refinement of the paper's table
    /// in place of the given ones when Table 1 level is not 0.
    void apply_table_1_level();

    std::string used_file_;
  };
} // namespace stiction

#endif
