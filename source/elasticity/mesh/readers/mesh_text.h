#ifndef stiction_source_elasticity_mesh_readers_mesh_text_h
#define stiction_source_elasticity_mesh_readers_mesh_text_h

#include <stiction/elasticity/mesh/readers/mesh_data.h>

#include <deal.II/base/utilities.h>

#include <cstdint>
#include <fstream>
#include <string>

namespace stiction
{
  using dealii::Utilities::trim;

  /// In capital letters.
  std::string upper(std::string text);

  /// A text file read line by line or word by word, which knows where it is.
  class MeshText
  {
  public:
    /// Throws InputError if the file cannot be read or is empty.
    MeshText(const std::string &file, std::string location);

    /// The next line, without spaces at its ends; false at the end of the
    /// file.
    bool next_line(std::string &line);

    /// What is left of the line, without spaces at its ends.
    std::string rest_of_line();

    /// The next word, on this line or a later one. Throws InputError at the
    /// end of the file, as the others do.
    std::string word();

    /// The next words, with a space between them.
    std::string words(std::uint64_t n);

    /// The next word as a whole number.
    std::int64_t integer();

    /// The next word as a whole number >= 0.
    std::uint64_t count();

    /// A word as a whole number. Throws InputError if it is none.
    std::int64_t to_integer(const std::string &word) const;

    /// A word as a whole number >= 0.
    std::uint64_t to_count(const std::string &word) const;

    /// A word as a finite number. Throws InputError if it is none.
    double to_real(const std::string &word) const;

    /// Throws InputError with the line and the reason.
    [[noreturn]] void refuse(const std::string &reason) const;

  private:
    bool read_line();

    std::ifstream in_;
    std::string location_;
    std::string line_;
    std::size_t position_ = 0;
    std::size_t number_   = 0;
  };

  /// A number of a boundary or a material as an id. Throws InputError if it
  /// is negative or absurd.
  unsigned int to_id(std::int64_t number, const MeshText &text);

  /// Gives a boundary or a material a name. Throws InputError if a parameter
  /// file could not use the name or if it is that of another part already.
  void add_name(const std::string &name, unsigned int id,
                std::map<std::string, unsigned int> &names, const MeshText &text);

  /// The readers of the formats.
  MeshData read_gmsh(MeshText &text);

  MeshData read_abaqus(MeshText &text);

  MeshData read_vtk(MeshText &text);
} // namespace stiction

#endif
