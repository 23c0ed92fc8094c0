#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <vector>

namespace stiction
{
  /// In capital letters.
  std::string upper(std::string text);

  /// A text file read line by line or word by word, which knows where it is.
  class TextScanner
  {
  public:
    /// @param location the beginning of a sentence about the file.
    /// @param comment what lines that are passed over begin with; none if empty.
    TextScanner(const std::string &file, std::string location, std::string comment = "");

    /// Whether it exists, is no directory and may be read.
    bool is_readable() const { return in_.is_open() && !in_.bad(); }

    bool is_empty() const { return line_number_ == 0 && in_.eof(); }

    /// The next line, without spaces at its ends; false at the end of the
    /// file.
    bool next_line(std::string &line);

    /// What is left of the line, without spaces at its ends.
    std::string rest_of_line();

    /// Goes to the next word, on this line or a later one; false at the end of
    /// the file.
    bool next_word();

    /// The word that next_word() went to.
    const std::string &this_word() const { return word_; }

    /// The next word. Throws InputError at the end of the file, as the others
    /// do.
    const std::string &word();

    /// Passes over the next words.
    void skip(std::uint64_t n_words);

    /// The next word as a whole number.
    std::int64_t integer();

    /// The next words as whole numbers.
    std::vector<std::int64_t> integers(std::uint64_t n);

    /// The next word as a whole number >= 0.
    std::uint64_t count();

    /// The next word as a finite number.
    double real();

    /// A word as a whole number. Throws InputError if it is none.
    std::int64_t to_integer(const std::string &word) const;

    /// A word as a whole number >= 0.
    std::uint64_t to_count(const std::string &word) const;

    /// A word as a number of at most 1e30, with an exponent that begins with e or, as
    /// Fortran writes it, with d. Throws InputError if it is none.
    double to_real(const std::string &word) const;

    /// A beginning of a line.
    struct Place
    {
      std::streampos position;
      std::size_t line_number;
    };

    /// That of the next line; only after next_line() or at the beginning of the file.
    Place here()
    {
      in_.clear(); // behind a last line that does not end
      return {in_.tellg(), line_number_};
    }

    /// Goes on there, from the end of the file as well.
    void go_to(const Place &place);

    /// Of the line, from 1.
    std::size_t line_number() const { return line_number_; }

    /// The beginning of a sentence about the line.
    std::string place() const;

    /// Throws InputError with the line and the reason.
    [[noreturn]] void refuse(const std::string &reason) const;

  private:
    bool read_line();

    std::ifstream in_;
    const std::string location_, comment_;
    std::string line_, word_;
    std::size_t position_    = 0; // in the line, behind what was read
    std::size_t line_number_ = 0;
  };
} // namespace stiction
