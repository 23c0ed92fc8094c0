#pragma once

#include <deal.II/base/parameter_acceptor.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace stiction
{
  class ParameterFile;

  /// The entries of a section that say what the shape of a body is and of how many
  /// coarse cells.
  struct ShapeParameters : dealii::ParameterAcceptor
  {
    /// Unknowns are numbered with 32 bits, in Trilinos and in MUMPS.
    static constexpr double max_cells = 4e8;

    bool is_brick() const { return type == "brick"; }

    /// The entry that says what the body is: the type, the generator or the
    /// file.
    std::string entry_of_shape() const;

    /// What the generator has to be given: "center : radius".
    std::string generator_takes() const;

    /// Of the brick; of other shapes, whose mesh is not made yet, 1. A double, because
    /// it may be anything before it is checked.
    double n_coarse_cells() const;

    /// The fewest coarse cells along an edge of the brick; of other shapes 1.
    double n_thinnest() const;

    std::string type;
    std::vector<double> lengths            = {};
    std::vector<unsigned int> subdivisions = {};
    std::optional<double> radius, inner_radius, length;
    std::string generator;
    std::string generator_arguments;
    std::string mesh_file;

    /// Names or numbers of the boundaries that other entries speak of.
    std::set<std::string> boundaries_in_use;

    /// The beginning of a sentence about entry_of_shape() and its value.
    std::string location;

    /// Of an entry, with the section.
    std::string entry(const std::string &name) const { return section_ + "/" + name; }

  protected:
    /// Declares the entries.
    explicit ShapeParameters(const std::string &section);

    /// Says where the body is said to be, and finds the mesh file.
    void locate(const ParameterFile &source);

    /// Throws InputError about what is missing and what a pattern cannot see.
    void check(const ParameterFile &source) const;

  private:
    void require_shape(const ParameterFile &source) const;

    const std::string section_;
  };
} // namespace stiction
