#pragma once

#include <stiction/contact/interface/state.h>
#include <stiction/simulation/checkpoint/mesh_history.h>

#include <nlohmann/json.hpp>

#include <deque>
#include <string>
#include <vector>

#include <mpi.h>

namespace stiction
{
  class LinearElasticity;
  class Parameters;

  /// All from which a computation goes on after a step.
  struct Checkpoint
  {
    nlohmann::json steps;     ///< TimeSteps::progress()
    nlohmann::json history;   ///< StepHistory::progress()
    std::deque<StepEnd> ends; ///< of the last steps, or the start, the last one first
    std::vector<std::string> slave_sides; ///< slave_sides() of the contact surface
  };

  /// Writes a checkpoint into the directory, as 'checkpoint'; the one before becomes
  /// 'checkpoint.old'. It is written beside them and renamed once the disk has it: a
  /// process that is killed at any moment leaves one that can be read. Collective.
  /// Throws InputError if it cannot be written.
  void write_checkpoint(const std::string &directory, const Checkpoint &checkpoint,
                        const MeshHistory &mesh, const LinearElasticity &elasticity,
                        const Parameters &parameters);

  /// A checkpoint that a computation goes on from, on any number of ranks.
  class CheckpointReader
  {
  public:
    /// Finds the checkpoint in an output directory, or takes the directory for the
    /// checkpoint itself, and looks at every byte of it. Collective. Throws InputError
    /// if there is none, if it is damaged, from a newer program, or of another problem,
    /// and then names the one before if that can be read.
    CheckpointReader(const std::string &directory, const Parameters &parameters,
                     MPI_Comm communicator);

    /// The checkpoint itself.
    const std::string &directory() const { return directory_; }

    /// The output directory that it lies in.
    std::string output_directory() const;

    /// How the mesh was refined. Collective.
    MeshHistory mesh() const;

    /// On the mesh refined like that. Collective. Throws InputError if it is another.
    Checkpoint read(const LinearElasticity &elasticity) const;

  private:
    StepEnd read_end(unsigned int k, const LinearElasticity &elasticity) const;

    const MPI_Comm communicator_;
    std::string directory_;
    nlohmann::json header_;
  };
} // namespace stiction
