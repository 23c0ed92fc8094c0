#include <stiction/base/text/parameter_file.h>
#include <stiction/base/units.h>
#include <stiction/output/output_parameters.h>

#include <deal.II/base/utilities.h>

namespace stiction
{
  namespace Patterns = dealii::Patterns;

  OutputParameters::OutputParameters()
    : ParameterAcceptor("Output")
  {
    add_parameter("Directory", directory,
                  "Where all results are written; made if it does not exist. "
                  "--output on the command line overrides it.");
    add_parameter("Export directory", export_directory,
                  "Where the discrete problem (Q, h, slip bound, areas, nodes) "
                  "and its solution are written for other programs, as an "
                  "FCLIB file and as Matrix Market files; empty: not written. "
                  "--export on the command line overrides it.");
    add_parameter("Units", units,
                  "The units in which this file is written, of length, force and stress; "
                  "with them labels of results are complete. Labels alone: nothing is "
                  "converted, and any consistent system may be used.",
                  prm, Patterns::Selection(Units::choices()));
    add_parameter("Write solution", write_solution,
                  "Whether solution.pvtu, the displacement and the stress in the whole "
                  "body, is written. contact.pvtu is always written.");
    add_parameter("Fields", fields,
                  "What solution.pvtu has. basic: displacement, stress, von "
                  "Mises stress, 0.1 kB an unknown on disk; all: strain, "
                  "principal stresses, the stress averaged at nodes over the "
                  "cells of the same material, reactions of the supports, "
                  "material and body as well, for twice the size and time.",
                  prm, Patterns::Selection("basic|all"));
    add_parameter("Double precision", double_precision,
                  "Whether displacement.csv, the displacement and the reaction of every "
                  "node of the body, and contact.csv, what happens at every contact "
                  "node, are written besides, as text with 17 digits. The .vtu files "
                  "have the 7 digits of single precision.");
    add_parameter("Every", every,
                  "With several load steps: files for ParaView are written of every n-th "
                  "step and of the last one. history.csv and energy.csv have all steps.",
                  prm, Patterns::Integer(1));
    add_parameter("Print progress", print_progress,
                  "Whether a line is printed for each step of the solver, and for "
                  "each load step.");
  }

  void OutputParameters::check(const ParameterFile &source) const
  {
    source.require(!dealii::Utilities::trim(directory).empty(), "Output/Directory",
                   "must name a directory");
    source.require(export_directory.empty() ||
                     !dealii::Utilities::trim(export_directory).empty(),
                   "Output/Export directory", "must name a directory or be empty");
    source.require(export_directory != directory, "Output/Export directory",
                   "must be another one than 'Output/Directory', from which a later "
                   "run would remove only its own files");
  }
} // namespace stiction
