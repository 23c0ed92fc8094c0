#pragma once

#include <stiction/contact/certificate/error_estimator.h>
#include <stiction/elasticity/linear_algebra/linear_algebra.h>

#include <deal.II/lac/vector.h>

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace stiction
{
  class ContactSurface;
  class LinearElasticity;
  class Parameters;
  struct State;

  /// What happens between two solves of an adaptive run: estimates the error
  /// of the answer on a mesh, chooses the cells to cut, and keeps the record of
  /// the meshes.
  class AdaptiveRefinement
  {
  public:
    /// The parameters must outlive the object.
    explicit AdaptiveRefinement(const Parameters &parameters);

    /// Takes note of a mesh that is solved, and if its answer is certified,
    /// estimates the error of that. Collective.
    ///
    /// @param state the answer, @param strain_energy uᵀKu/2 of it (J).
    void add_mesh(const LinearElasticity &elasticity, const ContactSurface &surface,
                  bool is_certified, const State &state, double strain_energy);

    /// Which active cells of the last mesh are to be cut, unless is_finished().
    /// Collective.
    ///
    /// @param elasticity, surface those given to add_mesh().
    std::vector<bool> cells_to_cut(const LinearElasticity &elasticity,
                                   const ContactSurface &surface);

    /// Whether cells_to_cut() left the last mesh as it is.
    bool is_finished() const { return is_finished_; }

    /// A line about the last mesh and what comes next, after cells_to_cut().
    const std::string &remark() const { return remark_; }

    /// η² of the last mesh, of its answer; of no cells if that was not
    /// certified.
    MeshError mesh_error() const;

    /// η_K of the last mesh by active cells, J^½: of its answer, if that was
    /// certified, otherwise empty.
    dealii::Vector<double> indicators() const;

    /// Whether the last mesh has a larger relative error than the first one.
    bool has_raised_error() const;

    /// The section "refinement" of summary.json: an entry for each mesh.
    nlohmann::json to_json() const;

  private:
    struct Mesh
    {
      double n_cells, n_unknowns, n_contact_nodes;
      double error;          ///< η in J^½; negative: not estimated
      double relative_error; ///< η/√(uᵀKu)
    };

    /// Why cells must not be cut: the error is small enough, or the next mesh
    /// too large; empty if they may.
    std::string objection(double n_cells_to_cut, double n_faces_to_cut,
                          MPI_Comm communicator) const;

    const Parameters &parameters_;
    std::vector<Mesh> meshes_;
    dealii::Vector<double> squares_;
    bool is_finished_ = false;
    std::string remark_, why_not_estimated_;
  };
} // namespace stiction
