#include "tetracone/kernel/number/number.h"
#include "tetracone/tetratree/door/contacts.h"
#include "tetracone/tetratree/door/contacts_data.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace tetracone {
namespace {

using detail::Contacts_data;
using kernel::Rational;
using kernel::Rational_point;

/// The line of the points base + s direction, where s is their coordinate along `axis`. It has one form, however it is
/// found.
struct Line {
  std::size_t axis;  ///< the first axis along which the line is not constant
  Rational_point direction, base;

  Line(const Rational_point& p, const Rational_point& q) : axis(0), direction{}, base{}
  {
    while (p[axis] == q[axis]) ++axis;
    for (std::size_t k = 0; k < 3; ++k) {
      direction[k] = (q[k] - p[k]) / (q[axis] - p[axis]);
      base[k] = p[k] - p[axis] * direction[k];
    }
  }

  Rational_point at(const Rational& s) const
  {
    return {Rational(base[0] + s * direction[0]), Rational(base[1] + s * direction[1]),
            Rational(base[2] + s * direction[2])};
  }

  friend bool operator<(const Line& x, const Line& y)
  {
    if (x.axis != y.axis) return x.axis < y.axis;
    return x.direction != y.direction ? x.direction < y.direction : x.base < y.base;
  }
};

/// Segments of one line, as pairs (begin, end).
using Spans = std::vector<std::pair<Rational, Rational>>;

/// Points, and the pairs of them that a segment joins, each once. Segments of one line that overlap, or end where the
/// next begins, are joined. They are cut where a segment of another line ends.
struct Graph {
  std::vector<Rational_point> points;
  std::vector<std::set<std::size_t>> joined;  // the points that are joined with the point of that number

  explicit Graph(const Contacts_data& data)
  {
    std::map<Line, Spans> lines;
    for (std::size_t k = 0; k < data.found.pieces.size(); ++k) {
      if (data.found.pieces[k].kind != Piece::segment) continue;
      const auto loops = detail::rational_loops(data, k);
      const Rational_point &p = loops[0][0], &q = loops[0][1];
      if (p == q) continue;
      const Line line(p, q);
      const Rational &s = p[line.axis], &t = q[line.axis];
      lines[line].push_back(s < t ? std::pair(s, t) : std::pair(t, s));
    }
    std::map<Rational_point, int> lines_at;  // the number of lines with a segment that ends there
    for (auto& [line, spans] : lines) {
      std::sort(spans.begin(), spans.end());
      for (const Rational& s : ends_of(spans)) ++lines_at[line.at(s)];
    }
    for (const auto& [line, spans] : lines) join(line, spans, lines_at);
  }

  bool take(std::size_t from, std::size_t to) { return joined[to].erase(from) + joined[from].erase(to) > 0; }

 private:
  static std::set<Rational> ends_of(const Spans& spans)
  {
    std::set<Rational> ends;
    for (const auto& [from, to] : spans) {
      ends.insert(from);
      ends.insert(to);
    }
    return ends;
  }

  /// Joins the points along a line. Requires spans in the order of their begins.
  void join(const Line& line, const Spans& spans, const std::map<Rational_point, int>& lines_at)
  {
    const std::set<Rational> ends = ends_of(spans);
    for (std::size_t k = 0; k < spans.size();) {
      const Rational from = spans[k].first;
      Rational to = spans[k].second;
      for (++k; k < spans.size() && spans[k].first <= to; ++k)
        if (to < spans[k].second) to = spans[k].second;
      Rational_point last = line.at(from);
      for (auto s = ends.upper_bound(from); s != ends.end() && *s <= to; ++s) {
        Rational_point next = line.at(*s);
        if (*s != to && lines_at.at(next) < 2) continue;
        join(last, next);
        last = std::move(next);
      }
    }
  }

  void join(const Rational_point& p, const Rational_point& q)
  {
    const std::size_t from = number(p), to = number(q);
    joined[from].insert(to);
    joined[to].insert(from);
  }

  std::size_t number(const Rational_point& x)
  {
    const auto [at, is_new] = numbers_.emplace(x, points.size());
    if (is_new) {
      points.push_back(x);
      joined.emplace_back();
    }
    return at->second;
  }

  std::map<Rational_point, std::size_t> numbers_;
};

std::array<double, 3> rounded(const Rational_point& x)
{
  return {kernel::nearest_double(x[0]), kernel::nearest_double(x[1]), kernel::nearest_double(x[2])};
}

}  // namespace

std::vector<Contacts::Curve> Contacts::curves() const
{
  Graph graph(*data_);
  std::vector<bool> is_through(graph.points.size());  // exactly two segments end there
  for (std::size_t k = 0; k < is_through.size(); ++k) is_through[k] = graph.joined[k].size() == 2;
  std::vector<Curve> curves;
  const auto follow = [&](std::size_t start) {
    while (!graph.joined[start].empty()) {
      Curve curve{false, {rounded(graph.points[start])}};
      for (std::size_t at = start; at == start ? curve.points.size() == 1 : is_through[at];) {
        const std::size_t next = *graph.joined[at].begin();
        graph.take(at, next);
        at = next;
        curve.closed = at == start;
        if (curve.closed) break;
        curve.points.push_back(rounded(graph.points[at]));
      }
      curves.push_back(std::move(curve));
    }
  };
  for (std::size_t k = 0; k < graph.points.size(); ++k)
    if (!is_through[k]) follow(k);
  for (std::size_t k = 0; k < graph.points.size(); ++k) follow(k);
  return curves;
}

}  // namespace tetracone
