#ifndef TETRACONE_TETRATREE_CERTIFICATE_PROOF_TEXT_H
#define TETRACONE_TETRATREE_CERTIFICATE_PROOF_TEXT_H

#include "tetracone/kernel/motion/body_motion.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/tetratree/certificate/cover.h"
#include "tetracone/tetratree/certificate/fractions.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

/// The JSON of certificates. experiments/certificates/README.md has the format.
namespace tetracone::tetratree {

/// Appends "key":, behind a comma unless it is the first key of its object.
inline void add_key(std::string& text, std::string_view key)
{
  if (text.back() != '{') text += ',';
  text += '"';
  text += key;
  text += "\":";
}

/// Appends a list of what text_of(x) returns for each element.
template <class Range, class Text_of>
void add_list(std::string& text, const Range& range, const Text_of& text_of)
{
  char before = '[';
  for (const auto& x : range) {
    text += std::exchange(before, ',');
    text += text_of(x);
  }
  text += before == '[' ? "[]" : "]";
}

/// Returns the text in quotes.
inline std::string json_text(std::string_view text)
{
  constexpr std::string_view digits = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20)
      quoted += std::string("\\u00") + digits[code / 16] + digits[code % 16];
    else
      quoted += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return quoted + "\"";
}

/// Returns a list of fractions, each a text.
template <class Numbers>
std::string strings_of(const Numbers& numbers)
{
  std::string text;
  add_list(text, numbers, [](const kernel::Rational& x) { return json_text(kernel::to_string(x)); });
  return text;
}

/// Appends numbers of the input under a key.
template <std::size_t size>
void add_given(std::string& text, std::string_view key, const std::array<kernel::Rational, size>& numbers)
{
  add_key(text, key);
  add_list(text, numbers, [](const kernel::Rational& x) { return json_text(kernel::exact_text(x)); });
}

inline void add_pose(std::string& text, std::string_view key, const kernel::Pose& pose)
{
  add_given(text, key, kernel::rows_of(pose));
}

inline void add_rigid_pose(std::string& text, std::string_view key, const kernel::Rigid_pose& pose)
{
  const auto& [w, x, y, z] = pose.quaternion;
  const auto& shift = pose.translation;
  add_given(text, key, std::array{w, x, y, z, shift[0], shift[1], shift[2]});
}

/// Returns a direction in lowest terms, as a list of texts. Directions of a few bits are most of a cover.
inline std::string direction_text(const kernel::Exact_vector& m)
{
  std::array<std::int64_t, 3> whole{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double near = m[k].to_double();
    if (!(std::abs(near) < 0x1p53) || near != std::trunc(near) || kernel::Exact_number(near) != m[k])
      return strings_of(in_lowest_terms(rational(m)));
    whole[k] = std::int64_t(near);
  }
  const std::int64_t factor = std::gcd(std::gcd(whole[0], whole[1]), whole[2]);
  std::string text;
  for (const std::int64_t x : whole) text += (text.empty() ? "[\"" : "\",\"") + std::to_string(x / factor);
  return text + "\"]";
}

inline void add_cover(std::string& text, const Cover& cover)
{
  add_key(text, "directions");
  add_list(text, cover.directions, direction_text);
  add_key(text, "cover");
  text += cover.nodes;
  for (const auto& [groups, box] : cover.opened) groups->open(box);
}

inline void add_witness(std::string& text, const std::array<kernel::Rational_point, 2>& points,
                        const std::array<Index, 2>& faces)
{
  add_key(text, "witness");
  text += '{';
  add_key(text, "points");
  add_list(text, points, [](const kernel::Rational_point& x) { return strings_of(x); });
  add_key(text, "faces");
  add_list(text, faces, [](Index f) { return std::to_string(f); });
  text += '}';
}

}  // namespace tetracone::tetratree

#endif
