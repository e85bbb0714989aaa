#ifndef TETRACONE_TETRATREE_PYTHON_ARRAYS_H
#define TETRACONE_TETRATREE_PYTHON_ARRAYS_H

#include "tetracone/tetratree/door/tetracone.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

/// Python's arrays, converted for the door. No number is rounded on the way: a number that is no double becomes a text.
namespace tetracone::python {

/// True for a sequence that is neither a text nor bytes: both are sequences too.
bool is_sequence(const pybind11::handle& value);

/// Returns the error, with `to` in place of `from` where its line begins with `from`.
Error renamed(const Error& error, std::string_view from, const std::string& to);

/// Returns how many answers n and m arguments ask for, where one of either serves all of the other. Throws Error for
/// other counts: "ABOUT: N FIRST and M SECOND; expected as many, or one of either".
std::size_t common_count(const std::string& about, std::size_t n, const std::string& first, std::size_t m,
                         const std::string& second);

/// An array of doubles, read in place, or of exact numbers as texts. A decimal stands for the double nearest to it, a
/// fraction "n/d" for itself.
class Numbers {
 public:
  /// Takes an array, which messages call `name`. Doubles are not copied, whatever their strides. Other numbers that are
  /// doubles become doubles. All others (fractions.Fraction, large integers, texts) become texts. Throws Error for rows
  /// of different lengths, for complex numbers, dates and records, and for masked entries. Any other value that is no
  /// number becomes a text that its reader refuses.
  Numbers(const pybind11::handle& values, std::string name);

  const std::string& name() const { return name_; }
  /// Return the number of dimensions, and the size of one.
  std::size_t dimensions() const { return shape_.size(); }
  std::size_t extent(std::size_t dimension) const { return shape_[dimension]; }
  /// Returns the shape as a text, "(10, 3, 4)".
  std::string shape() const;

  /// True when the numbers are texts, since some are no doubles.
  bool is_exact_text() const { return exact_; }

  /// Return the address of the first double, and the bytes from one index of a dimension to the next. Require doubles.
  const char* data() const { return data_; }
  std::ptrdiff_t stride(std::size_t dimension) const { return strides_[dimension]; }

  /// Returns the double at these indices, one for each dimension. Requires doubles. Needs no interpreter's lock.
  template <class... Indices>
  double number(Indices... indices) const
  {
    double value;
    std::memcpy(&value, data_ + offset(strides_, indices...), sizeof value);
    return value;
  }

  /// Returns the text at these indices. Requires texts. Needs no interpreter's lock.
  template <class... Indices>
  const std::string& text(Indices... indices) const
  {
    return texts_[offset(text_strides_, indices...)];
  }

 private:
  template <class Strides, class... Indices>
  static std::ptrdiff_t offset(const Strides& strides, Indices... indices)
  {
    std::ptrdiff_t sum = 0;
    std::size_t k = 0;
    ((sum += strides[k++] * std::ptrdiff_t(indices)), ...);
    return sum;
  }

  std::string name_;
  pybind11::array array_;  // keeps the data
  const char* data_ = nullptr;
  std::vector<std::size_t> shape_;
  std::vector<std::ptrdiff_t> strides_, text_strides_;
  bool exact_ = false;
  std::vector<std::string> texts_;
};

/// Rows of numbers: an array (n, width), or one row (width,).
template <std::size_t width>
class Rows {
 public:
  /// Takes an array. Messages call it `name`, and a row `one`. Throws Error for another shape, and as `Numbers`.
  Rows(const pybind11::object& values, const std::string& name, const std::string& one)
      : name_(name), numbers_(values, name)
  {
    const std::size_t dimensions = numbers_.dimensions();
    const std::string columns = std::to_string(width);
    if ((dimensions != 1 && dimensions != 2) || numbers_.extent(dimensions - 1) != width)
      throw Error(name + ": an array of shape " + numbers_.shape() + "; expected (n, " + columns + "), or one " + one +
                  " (" + columns + ",)");
    is_one_ = dimensions == 1;
  }

  /// True for one row (width,).
  bool is_one() const { return is_one_; }
  std::size_t count() const { return is_one_ ? 1 : numbers_.extent(0); }
  /// True when rows are texts: see `Numbers`.
  bool is_exact_text() const { return numbers_.is_exact_text(); }

  /// Return row `k`: `row` of doubles, `text` of texts. Need no interpreter's lock.
  std::array<double, width> row(std::size_t k) const
  {
    std::array<double, width> row;
    for (std::size_t i = 0; i < width; ++i) row[i] = is_one_ ? numbers_.number(i) : numbers_.number(k, i);
    return row;
  }
  std::array<std::string, width> text(std::size_t k) const
  {
    std::array<std::string, width> text;
    for (std::size_t i = 0; i < width; ++i) text[i] = is_one_ ? numbers_.text(i) : numbers_.text(k, i);
    return text;
  }

  /// Returns the name of row `k` in messages.
  std::string name(std::size_t k) const { return is_one_ ? name_ : name_ + "[" + std::to_string(k) + "]"; }

 private:
  std::string name_;
  Numbers numbers_;
  bool is_one_;
};

/// Poses of one body: an array (n, 3, 4) or (n, 4, 4), or one pose (3, 4) or (4, 4), or None for the identity.
class Poses {
 public:
  /// Takes an array, which messages call `name`. Throws Error for another shape, and as `Numbers`. Numbers that are no
  /// pose are refused when the pose is asked for.
  Poses(const pybind11::object& values, const std::string& name);

  /// True for one pose and None.
  bool is_one() const { return is_one_; }
  std::size_t count() const { return count_; }

  /// Returns pose `k`. Throws Error where it is no pose; `require` adds its name. Needs no interpreter's lock.
  Pose operator()(std::size_t k) const
  {
    if (packed_) [[likely]] {
      std::array<double, 12> rows;
      std::memcpy(rows.data(), packed_ + std::ptrdiff_t(k) * stride_, sizeof rows);
      return Pose(rows);
    }
    return numbers_ ? made(k) : Pose();
  }

  /// Throws Error with the name of pose `k` where it is no pose.
  void require(std::size_t k) const;

  /// Returns the name of pose `k` in messages.
  std::string name(std::size_t k) const;

 private:
  Pose made(std::size_t k) const;

  std::string name_;
  std::unique_ptr<Numbers> numbers_;  // null: the identity
  bool is_one_ = true;
  std::size_t count_ = 1, rows_ = 3;
  std::ptrdiff_t stride_ = 0;
  const char* packed_ = nullptr;  // the numbers of pose 0 where each pose (3, 4) is contiguous
};

/// Returns the polyhedron of vertices (n, 3) and faces. Faces are an array (m, k) of vertex numbers, or a sequence. A
/// face in a sequence is a sequence of numbers, or of loops of numbers with the outer one first. Throws Error for
/// anything else.
Polyhedron polyhedron_of(const pybind11::handle& vertices, const pybind11::handle& faces);

/// Returns a list of faces, each a list of loops, each a tuple of vertex numbers.
pybind11::list faces_of(const Polyhedron& polyhedron);

/// Returns the vertices (n, 3), a read-only view of the memory of `owner`.
pybind11::array vertices_of(const Polyhedron& polyhedron, const pybind11::handle& owner);

}  // namespace tetracone::python

#endif
