#include "verify/truth/contact_pieces.h"

#include <algorithm>

namespace tetracone::verify {
namespace {

using kernel::Piece;
using kernel::Rational;

bool on_one_line(const Exact_point& a, const Exact_point& b, const Exact_point& c)
{
  for (int k = 0; k < 3; ++k) {
    const int l = (k + 1) % 3;
    if ((b[k] - a[k]) * (c[l] - a[l]) != (b[l] - a[l]) * (c[k] - a[k])) return false;
  }
  return true;
}

Exact_segment in_order(const Exact_point& a, const Exact_point& b)
{
  return a < b ? Exact_segment(a, b) : Exact_segment(b, a);
}

/// Extends a by b if they are on one line and share a point. Points are ordered as along any line.
bool take_in(Exact_segment& a, const Exact_segment& b)
{
  if (a.second < b.first || b.second < a.first) return false;
  const auto on_line = [&](const Exact_segment& s) {
    return on_one_line(s.first, s.second, b.first) && on_one_line(s.first, s.second, b.second);
  };
  if (!on_line(a)) return false;
  a = {std::min(a.first, b.first), std::max(a.second, b.second)};
  return true;
}

}  // namespace

std::vector<Exact_segment> maximal_segments(std::vector<Exact_segment> segments)
{
  std::vector<Exact_segment> maximal;
  for (Exact_segment& segment : segments) {
    // A segment that grows may meet others.
    for (std::size_t k = 0; k < maximal.size();) {
      if (!take_in(segment, maximal[k])) {
        ++k;
        continue;
      }
      maximal.erase(maximal.begin() + std::ptrdiff_t(k));
      k = 0;
    }
    maximal.push_back(segment);
  }
  std::sort(maximal.begin(), maximal.end());
  return maximal;
}

Contact_piece_form piece_form(std::uint32_t face_a, std::uint32_t face_b, Piece kind, kernel::Feature in_a,
                              kernel::Feature in_b, const std::vector<std::vector<Exact_point>>& loops)
{
  std::vector<Exact_segment> border;
  for (const auto& loop : loops) {
    if (kind == Piece::point) border.push_back({loop[0], loop[0]});
    if (kind == Piece::segment) border.push_back(in_order(loop[0], loop[1]));
    if (kind == Piece::polygon)
      for (std::size_t k = 0; k < loop.size(); ++k) border.push_back(in_order(loop[k], loop[(k + 1) % loop.size()]));
  }
  if (kind == Piece::polygon) border = maximal_segments(std::move(border));
  return {face_a, face_b, kind, in_a, in_b, std::move(border)};
}

Contact_forms with_joined_polygons(const Contact_forms& forms)
{
  Contact_forms joined;
  for (const Contact_piece_form& form : forms) {
    const auto same = std::find_if(joined.begin(), joined.end(), [&](const Contact_piece_form& other) {
      return form.kind == Piece::polygon && other.kind == Piece::polygon && form.face_a == other.face_a &&
             form.face_b == other.face_b;
    });
    if (same == joined.end()) {
      joined.push_back(form);
    } else {
      same->border.insert(same->border.end(), form.border.begin(), form.border.end());
      same->border = maximal_segments(std::move(same->border));
    }
  }
  std::sort(joined.begin(), joined.end());
  return joined;
}

int dimension(const Contact_forms& forms)
{
  int dimension = -1;
  for (const Contact_piece_form& form : forms)
    dimension = std::max(dimension, form.kind == kernel::Piece::point     ? 0
                                    : form.kind == kernel::Piece::segment ? 1
                                                                          : 2);
  return dimension;
}

std::string to_string(const Contact_piece_form& form)
{
  std::string text = "faces " + std::to_string(form.face_a) + ", " + std::to_string(form.face_b) + ": " +
                     std::string(to_string(form.kind)) + " (" + std::string(to_string(form.in_a)) + ", " +
                     std::string(to_string(form.in_b)) + ")";
  for (const auto& [from, to] : form.border)
    for (const Exact_point* x : {&from, &to})
      text +=
          " (" + kernel::to_string((*x)[0]) + " " + kernel::to_string((*x)[1]) + " " + kernel::to_string((*x)[2]) + ")";
  return text;
}

}  // namespace tetracone::verify
