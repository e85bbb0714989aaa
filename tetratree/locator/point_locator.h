#ifndef TETRACONE_TETRATREE_LOCATOR_POINT_LOCATOR_H
#define TETRACONE_TETRATREE_LOCATOR_POINT_LOCATOR_H

#include "tetracone/covering/inclusion.h"
#include "tetracone/kernel/bound/cone_cells.h"
#include "tetracone/kernel/bound/cone_probe.h"
#include "tetracone/kernel/bound/cone_slab.h"
#include "tetracone/kernel/bound/relative_frame.h"
#include "tetracone/kernel/number/products.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <vector>

namespace tetracone::tetratree {

/// The location of points with regard to a solid, exactly, by the directions of tetra-cones in one look-up.
///
/// A table covers cells of directions about the covering's origin. For each cell it has the intervals of norm |x| + |y|
/// + |z| of the covering's triangles that the cell's rays meet. Intervals that overlap are merged to groups, so that
/// groups are disjoint. Between groups there is no surface; the winding number is constant there, and stored. A slab
/// holds a group's triangles; on either side of it there is no surface either. For a point within the slab, the signed
/// inclusions (JS08 Theorem 1) of the group's triangles are added to the winding number beyond. Its ray outwards
/// crosses no other triangle before that. Cells, intervals and slabs are rounded outward. A filter decides triangles
/// first; uncertain ones go to exact signs.
///
/// The locator takes from JS08 section 2.2 that only tetrahedra that meet the cone of a point can hold it. All cones
/// are cells of one lattice (`Cone_cells`), found by a division instead of signs. Nothing changes after construction,
/// so any number of threads may use it. Each requires sound floating point (`kernel::require_sound_floating_point`).
class Point_locator {
 public:
  using K = kernel::Adaptive;
  using Model = covering::Model<K>;
  using Location = covering::Location;
  using Index = covering::Index;
  using Cone_cells = kernel::Cone_cells;

  /// Builds the table. Requires a closed model, which must outlive this object.
  explicit Point_locator(const Model& model)
      : model_(&model),
        scale_(kernel::local_scale(model.lattice().origin, model.vertices())),
        per_half_unit_(2 / scale_.unit),
        cells_(steps_for(model.covering().triangles().size()))
  {
    vertices_.reserve(model.vertices().size());
    bool is_local = true;
    for (const covering::Vertex& v : model.vertices()) {
      const kernel::Local_point p = local(v);
      for (const double x : p) is_local = is_local && std::abs(x) <= 1;
      vertices_.push_back(kernel::rounded(p));
    }
    if (is_local) make_table();  // otherwise coordinates are near the largest doubles
  }
  Point_locator(const Point_locator&) = delete;

  /// Returns the location of a point. Requires finite coordinates.
  Location locate(const covering::Vertex& point) const
  {
    return locate(local(point), [&] { return K::unmoved(point); });
  }

  /// Returns the locations of many points. It interleaves them, so that memory accesses for some overlap with work on
  /// others. Requires answers.size() == points.size().
  void locate(std::span<const covering::Vertex> points, std::span<Location> answers) const
  {
    std::array<Asked, at_a_time> asked;
    std::array<Pending, at_a_time> pending;
    for (std::size_t first = 0; first < points.size(); first += at_a_time) {
      const std::size_t count = kernel::minimum(at_a_time, points.size() - first);
      for (std::size_t k = 0; k < count; ++k) {
        ask(local(points[first + k]), asked[k]);
        if (asked[k].cell != none) __builtin_prefetch(&cell_groups_[asked[k].cell]);
      }
      for (std::size_t k = 0; k < count; ++k)
        if (asked[k].cell != none) {
          const Group* const first_of_cell = groups_.data() + cell_groups_[asked[k].cell];
          __builtin_prefetch(first_of_cell);
          __builtin_prefetch(first_of_cell + 2);
        }
      std::size_t left = 0;
      for (std::size_t k = 0; k < count; ++k) {
        pending[left].number = k;
        left += !decide(asked[k], answers[first + k], pending[left].group);
      }
      prefetch(std::span(pending).first(left));
      for (std::size_t k = 0; k < left; ++k) {
        const covering::Vertex& point = points[first + pending[k].number];
        answers[first + pending[k].number] =
            by_triangles(asked[pending[k].number], pending[k].group, [&] { return K::unmoved(point); });
      }
    }
  }

  /// Returns the location of a rational point.
  Location locate(const std::array<kernel::Rational, 3>& point) const
  {
    // A pose has no such entries, and a body no vertices beyond the largest double.
    for (const kernel::Rational& x : point)
      if (!(std::abs(x.get_d()) < 0x1p1023) && !std::isfinite(kernel::nearest_double(x))) return Location::outside;
    kernel::Local_point at;
    for (int k = 0; k < 3; ++k)
      at[k] = kernel::nearest_double(kernel::times_power(
          kernel::Rational(point[k] - kernel::Rational(scale_.origin[k])), -std::ilogb(scale_.unit)));
    std::optional<kernel::Pose> translation;  // made where triangles decide, for it takes longer than all else
    return locate(at, [&] {
      if (!translation)
        translation.emplace(std::array<kernel::Rational, 12>{1, 0, 0, point[0], 0, 1, 0, point[1], 0, 0, 1, point[2]});
      return K::placed({0, 0, 0}, *translation);
    });
  }

  /// Returns the bytes held, except the model's.
  std::size_t bytes() const
  {
    return cell_groups_.capacity() * sizeof(Index) + groups_.capacity() * sizeof(Group) +
           entries_.capacity() * sizeof(Index) + heights_.capacity() +
           vertices_.capacity() * sizeof(kernel::Rounded_point);
  }

 private:
  /// Triangles of a cell, from entry `first` on, whose intervals overlap in a chain.
  struct Group {
    float low, high;                ///< bounds of the norms of the triangles' parts in the cell
    kernel::Cone_slab slab;         ///< about these parts
    Index first;                    ///< this group's first entry; the next group's first ends it
    std::int32_t within_and_sheet;  ///< 2 * within() + is_sheet()

    /// Returns the winding number on the origin's side, as far as the previous group.
    int within() const { return within_and_sheet >> 1; }
    bool is_sheet() const { return (within_and_sheet & 1) != 0; }

    /// Returns a norm of the group in steps of 0 to 254; it is monotone in spite of rounding.
    double steps(double norm) const { return (norm - low) * (254 / (double(high) - low)); }
  };

  /// A triangle in a cell while the table is made.
  struct Found {
    Index cell, triangle;
    float low, high;
  };

  static constexpr Index none = covering::none;
  /// Points that are interleaved.
  static constexpr std::size_t at_a_time = 64;
  static constexpr double farthest = 4;  ///< upper bound of a norm for which signs may be used

  /// A query point and the cell that holds it. It has no cell far beyond the surface, in the core, or without a table.
  struct Asked {
    kernel::Local_point at;
    double norm;
    Index cell;
  };
  /// The number of a point that triangles decide: a group's triangles, or all.
  struct Pending {
    std::size_t number;
    Index group, end;
  };

  /// The contribution of one triangle to a point.
  struct Seen {
    int winding = 0;       ///< its part of the winding number
    int facing = 0;        ///< if certain: how its edges turn about the ray through the point, or its reverse
    bool on_face = false;  ///< the point is on the triangle's face
  };

  /// Returns the number of steps per edge for about two triangles per cell.
  static int steps_for(std::size_t triangles)
  {
    return std::clamp(int(std::sqrt(double(triangles) / 8)), 2, Cone_cells::most);
  }

  kernel::Local_point local(const covering::Vertex& p) const
  {
    kernel::Local_point at;
    for (int k = 0; k < 3; ++k) at[k] = (0.5 * p[k] - 0.5 * scale_.origin[k]) * per_half_unit_;
    return at;
  }

  kernel::Local_triangle triangle(Index t) const
  {
    const auto& corner = model_->covering().triangles()[t].corner;
    const auto& vertices = model_->vertices();
    return {local(vertices[corner[0]]), local(vertices[corner[1]]), local(vertices[corner[2]])};
  }

  static Location location(int winding) { return winding != 0 ? Location::inside : Location::outside; }

  /// Returns the location of p, in local units; very far points are infinite there. `exact()` returns the point in K.
  template <class Exact>
  Location locate(const kernel::Local_point& p, const Exact& exact) const
  {
    Asked asked;
    ask(p, asked);
    Location at;
    Index group;
    return decide(asked, at, group) ? at : by_triangles(asked, group, exact);
  }

  /// Writes a point and its cell.
  void ask(const kernel::Local_point& p, Asked& asked) const
  {
    // Stored one by one: a read of the whole right after writes of parts would stall on store forwarding.
    for (int k = 0; k < 3; ++k) asked.at[k] = p[k];
    const double norm = asked.norm = kernel::octahedral_norm(p);
    const bool has_cell = has_table_ && norm >= Cone_cells::core && norm <= farthest;
    asked.cell = has_cell ? Index(cells_.cell(p, norm)) : none;
  }

  /// True when no triangle is needed. Then `at` is the answer; else the triangles of `group` decide, or all if it is
  /// none.
  bool decide(const Asked& asked, Location& at, Index& group) const
  {
    if (asked.cell == none) [[unlikely]] {
      group = none;
      return decide_without_cell(asked, at);
    }
    const Index first = cell_groups_[asked.cell], end = cell_groups_[asked.cell + 1];
    // Branchless, since a branch would be unpredictable: it tests the first three groups together, and both the norm
    // and the slab.
    const auto is_passed = [&](Index g) { return Index((g + 1 < end) & (asked.norm > groups_[g].high)); };
    Index g = first + is_passed(first) + is_passed(first + 1) + is_passed(first + 2);
    if (end > first + 4) [[unlikely]]
      while (is_passed(g) != 0) ++g;
    const Group& of = groups_[g];
    // `side` is 1 beyond the group and -1 before it, by the norm; else it is the slab's side. The slab's mask is 0
    // where the norm decides, else all ones. The winding number is the group's inner one before it, else the outer one.
    const int is_beyond = (first == end) | (asked.norm > of.high), is_before = (asked.norm < of.low) & ~is_beyond;
    const int side = (is_beyond - is_before) | (of.slab.side(asked.at) & ((is_beyond | is_before) - 1));
    const int outer = beyond(asked.cell, g);
    at = location(outer ^ ((outer ^ of.within()) & -int(side < 0)));
    group = g;
    return side != 0;
  }

  bool decide_without_cell(const Asked& asked, Location& at) const
  {
    at = Location::outside;
    if (has_table_ && asked.norm > farthest) return true;
    if (!has_table_ || !core_) return false;
    at = location(*core_);
    return true;
  }

  /// Returns the winding number beyond a group of the cell.
  int beyond(Index cell, Index g) const { return int(g + 1 < cell_groups_[cell + 1]) * groups_[g + 1].within(); }

  /// Returns the steps above which triangles of the group may reach `norm`, a norm of the group.
  int least_height(const Group& of, double norm) const { return of.is_sheet() ? -1 : int(of.steps(norm)); }

  /// Prefetches the first triangles of groups.
  void prefetch(std::span<Pending> pending) const
  {
    const auto& triangles = model_->covering().triangles();
    for (const Pending& p : pending) {
      if (p.group == none) continue;
      const Index first = groups_[p.group].first;
      __builtin_prefetch(&entries_[first]);
      __builtin_prefetch(&heights_[first]);
    }
    for (Pending& p : pending)
      if (p.group != none) p.end = kernel::minimum(groups_[p.group].first + 8, groups_[p.group + 1].first);
    const auto for_first_triangles = [&](const auto& what) {
      for (const Pending& p : pending)
        if (p.group != none)
          for (Index e = groups_[p.group].first; e < p.end; ++e) what(e);
    };
    for_first_triangles([&](Index e) { __builtin_prefetch(&triangles[entries_[e]]); });
    for_first_triangles([&](Index e) {
      for (const Index v : triangles[entries_[e]].corner) __builtin_prefetch(&vertices_[v]);
    });
  }

  /// Returns the location of a point by triangles of a group, or by all.
  template <class Exact>
  Location by_triangles(const Asked& asked, Index group, const Exact& exact) const
  {
    if (group == none) return locate_among_all(asked.at, exact);
    constexpr std::array<std::int8_t, 16> counts = {0, 1, 1, 2, 1, 2, 2, 3, 1, 2, 2, 3, 2, 3, 3, 4};  // of bits
    const Group& of = groups_[group];
    const int outer = beyond(asked.cell, group), way = of.within() - outer;
    const Index end = groups_[group + 1].first;
    const int height = least_height(of, asked.norm);
    const kernel::Cone_probe probe(asked.at);
    int winding = outer;
    // The highest are first.
    for (Index e = of.first; e < end && heights_[e] > height; e += 4) {
      const kernel::Cone_probe::Views views = view(probe, e, end);
      if (const unsigned met = way > 0 ? views.left : views.right; of.is_sheet() && met != 0)
        return location((views.before & met) != 0 ? of.within() : outer);
      winding += counts[views.left & views.before] - counts[views.right & views.before];
      for (unsigned undecided = views.undecided; undecided != 0; undecided &= undecided - 1) {
        const Seen seen = see(entries_[e + Index(std::countr_zero(undecided))], asked.at, exact);
        if (seen.on_face) return Location::on_surface;
        winding += seen.winding;
        if (of.is_sheet() && seen.facing == way) return location(winding);
      }
    }
    return location(winding);
  }

  /// Returns the signs of the next four triangles, or of fewer up to `end`.
  kernel::Cone_probe::Views view(const kernel::Cone_probe& probe, Index first, Index end) const
  {
    std::array<kernel::Cone_probe::Corners, 3> corners;
    for (Index k = 0; k < 4; ++k) {
      const auto& corner = model_->covering().triangles()[entries_[kernel::minimum(first + k, end - 1)]].corner;
      for (std::size_t c = 0; c < 3; ++c) corners[c][k] = vertices_[corner[c]];
    }
    const auto [left, right, before, undecided] = probe(corners[0], corners[1], corners[2]);
    const unsigned those = end - first < 4 ? (1u << (end - first)) - 1 : 15;
    return {left & those, right & those, before & those, undecided & those};
  }

  /// Returns the location of a point by all triangles.
  template <class Exact>
  Location locate_among_all(const kernel::Local_point& p, const Exact& exact) const
  {
    int winding = 0;
    for (Index t = 0; t < model_->covering().triangles().size(); ++t) {
      const Seen seen = see(t, p, exact);
      if (seen.on_face) return Location::on_surface;
      winding += seen.winding;
    }
    return location(winding);
  }

  /// Decides a triangle, by a filter first. A face lies within its covering's triangles, so p is on none of it if the
  /// filter is certain.
  template <class Exact>
  Seen see(Index t, const kernel::Local_point& p, const Exact& exact) const
  {
    if (has_table_ && kernel::octahedral_norm(p) <= farthest) {
      const auto [w, a, b] = triangle(t);
      const int facing = kernel::cone_holds(w, a, b, p);
      if (facing == 0) return {};
      if (facing != kernel::cone_undecided)
        if (const int side = kernel::plane_side(w, a, b, p); side != 0)
          return {.winding = side == -facing ? facing : 0, .facing = facing};
    }
    return see_exactly(model_->covering().triangles()[t], exact());
  }

  /// Returns `covering::signed_inclusion` of p in the triangle's tetrahedron, or that p is on the face.
  [[gnu::noinline]] Seen see_exactly(const covering::Covering_triangle& t, const K::Point_3& p) const
  {
    const auto corner = [&](int k) { return model_->point(t.corner[k]); };
    if (kernel::segment_face<K>(p, p, covering::Model_face<K>(*model_, t.face)) != kernel::Contact::none)
      return {.on_face = true};
    return {.winding = covering::signed_inclusion<K>(p, model_->origin(), corner(0), corner(1), corner(2))};
  }

  /// Builds the table; leaves the locator without one if triangles span too many cells.
  void make_table()
  {
    const auto count = Index(model_->covering().triangles().size());
    std::vector<Found> found;
    found.reserve(8 * std::size_t(count));
    bool core_is_empty = true;
    // Bodies whose triangles span many cells get fewer cells, or no table.
    const std::size_t most = 64 * std::size_t(count) + 65536;
    for (Index t = 0; t < count; ++t) {
      const auto add = [&](std::size_t cell, float low, float high) { found.push_back({Index(cell), t, low, high}); };
      core_is_empty = cells_.for_cells(kernel::Local_facet(triangle(t)), add) && core_is_empty;
      if (found.size() <= most) continue;
      if (cells_.n() == 2) return;
      cells_ = Cone_cells(kernel::maximum(cells_.n() / 2, 2));
      found.clear();
      core_is_empty = true;
      t = Index(-1);  // the loop restarts at triangle 0
    }
    const std::vector<Index> begin = sort_by_cells(found);
    // All arrays get their final capacity at once: page faults would take longer than everything else.
    std::size_t groups = 0;
    for (std::size_t cell = 0; cell < cells_.count(); ++cell)
      groups += group_count(found.data() + begin[cell], found.data() + begin[cell + 1]);
    cell_groups_.reserve(cells_.count() + 1);
    groups_.reserve(groups + 3);
    entries_.reserve(found.size());
    heights_.reserve(found.size());
    std::vector<kernel::Local_facet> scratch;
    cells_.for_directions([&](std::size_t cell, const kernel::Local_point& d, const Cone_cells::Corners& corners) {
      cell_groups_.push_back(Index(groups_.size()));
      group(found.data() + begin[cell], found.data() + begin[cell + 1]);
      sum_inwards(cell_groups_.back(), found.data() + begin[cell], d, corners, scratch);
    });
    if (core_is_empty) core_ = cell_groups_.back() < groups_.size() ? groups_[cell_groups_.back()].within() : 0;
    cell_groups_.push_back(Index(groups_.size()));
    // Queries of an empty last cell read three groups from its beginning.
    groups_.insert(groups_.end(), 3, {0, 0, {}, Index(entries_.size()), 0});
    has_table_ = true;
  }

  /// Sorts by cells, in place, by swaps. Returns where each cell begins, and as the last entry where all end.
  std::vector<Index> sort_by_cells(std::vector<Found>& found) const
  {
    std::vector<Index> begin(cells_.count() + 1, 0);
    for (const Found& f : found) ++begin[f.cell];
    std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), Index(0));
    std::vector<Index> next = begin;
    for (Index cell = 0; cell < cells_.count(); ++cell)
      while (next[cell] < begin[cell + 1]) {
        Found& here = found[next[cell]];
        if (here.cell == cell)
          ++next[cell];
        else
          std::swap(here, found[next[here.cell]++]);
      }
    return begin;
  }

  /// Sorts a cell's triangles by their low ends; returns the number of their groups.
  static std::size_t group_count(Found* first, Found* last)
  {
    std::sort(first, last, [](const Found& x, const Found& y) { return x.low < y.low; });
    std::size_t count = 0;
    float high = 0;
    for (const Found* f = first; f != last; ++f) {
      const bool is_new = f == first || f->low > high;
      count += is_new;
      high = is_new ? f->high : kernel::maximum(high, f->high);
    }
    return count;
  }

  /// Appends the groups of a cell's triangles, which are sorted.
  void group(const Found* first, const Found* last)
  {
    for (const Found* f = first; f != last; ++f) {
      if (f != first && f->low <= groups_.back().high)
        groups_.back().high = kernel::maximum(groups_.back().high, f->high);
      else
        groups_.push_back({f->low, f->high, {}, Index(entries_.size()), 0});
      entries_.push_back(f->triangle);
      heights_.push_back(0);
    }
  }

  /// Computes the winding numbers of the cell's groups, which begin at `first`, by crossings of its ray, the farthest
  /// first. `found` has the cell's triangles, in the groups' order; it is changed. `facets` is scratch memory.
  void sum_inwards(Index first, Found* found, const kernel::Local_point& direction, const Cone_cells::Corners& corners,
                   std::vector<kernel::Local_facet>& facets)
  {
    if (groups_.size() == first) return;
    const kernel::Cone_probe probe(direction);
    int winding = 0;
    auto end = Index(entries_.size());
    for (std::size_t g = groups_.size(); g-- > first;) {
      const Index begin = groups_[g].first;
      facets.clear();
      int facing[3] = {0, 0, 0};
      const int beyond = winding;
      for (Index e = begin; e < end; ++e) {
        const auto& [w, a, b] = facets.emplace_back(triangle(entries_[e])).corner;
        ++facing[1 + kernel::cone_side(w, a, b)];
      }
      Index crossed = begin;
      for (Index e = begin; e < end; e += 4) {
        const kernel::Cone_probe::Views views = view(probe, e, end);
        for (unsigned met = views.left | views.right | views.undecided; met != 0; met &= met - 1) {
          const auto k = unsigned(std::countr_zero(met));
          const int sign = crossing(entries_[e + k], facets[e + k - begin].corner, views.facing(k), direction);
          winding += sign;
          if (sign != 0) crossed = e + k;
        }
      }
      std::swap(entries_[crossed], entries_[begin]);  // other points likely meet it, too
      const bool sheet = is_sheet(winding - beyond, kernel::maximum(facing[0], facing[2]), int(facets.size()));
      groups_[g].slab = kernel::Cone_slab(corners, facets);
      groups_[g].within_and_sheet = 2 * winding + sheet;
      if (!sheet) order_by_heights(g, std::span(found + (begin - groups_[first].first), facets.size()));
      end = begin;
    }
  }

  /// Sorts a group's entries by height, the highest first.
  void order_by_heights(std::size_t g, std::span<Found> found)
  {
    std::sort(found.begin(), found.end(), [](const Found& x, const Found& y) { return x.high > y.high; });
    Index e = groups_[g].first;
    for (const Found& f : found) {
      entries_[e] = f.triangle;
      heights_[e++] = std::uint8_t(int(groups_[g].steps(f.high)) + 1);
    }
  }

  /// True when the group is a sheet: each ray of the cell crosses it once. The crossings sum to one over the whole cell
  /// and are all of one sign. So one triangle that a ray surely crosses decides. No triangle is seen edge-on: such a
  /// one might hold points and count for nothing.
  static bool is_sheet(int crossings, int most_of_one_sign, int count)
  {
    return std::abs(crossings) == 1 && most_of_one_sign == count;
  }

  /// Returns the sign of the triangle if the ray from the origin crosses it, else 0. The ray is moved by the same
  /// infinitesimal for all triangles. `facing` says how the triangle's edges turn about the ray, if that is known.
  int crossing(Index t, const kernel::Local_triangle& corner, int facing, const kernel::Local_point& direction) const
  {
    const auto& [w, a, b] = corner;
    if (facing == kernel::cone_undecided) facing = kernel::cone_holds(w, a, b, direction);
    if (facing == 0) return 0;
    // If the triangle's own sign differs, the opposite ray crosses it.
    const int volume = kernel::cone_side(w, a, b);
    if (facing != kernel::cone_undecided && volume != 0) return volume == facing ? facing : 0;
    return exact_crossing(model_->covering().triangles()[t], direction);
  }

  /// Returns as `crossing`, by exact signs. The sides of the ray are those of its point at norm 1, moved with it.
  int exact_crossing(const covering::Covering_triangle& t, const kernel::Local_point& direction) const
  {
    const kernel::Pose to_origin = kernel::Pose::translation(scale_.origin[0], scale_.origin[1], scale_.origin[2]);
    const K::Point_3 p = K::placed(kernel::scaled(direction, scale_.unit), to_origin);
    const auto corner = [&](int k) { return model_->point(t.corner[k]); };
    const K::Point_3& o = model_->origin();
    const kernel::Sign volume = kernel::volume_sign<K>(o, corner(0), corner(1), corner(2));
    if (volume == kernel::ZERO) return 0;
    for (int k = 0; k < 3; ++k)
      if (kernel::perturbed_side<K>(o, corner(k), corner((k + 1) % 3), p) != volume) return 0;
    return volume;
  }

  const Model* model_;
  kernel::Local_scale scale_;
  double per_half_unit_;
  kernel::Cone_cells cells_;
  std::vector<kernel::Rounded_point> vertices_;  ///< of the model
  bool has_table_ = false;
  std::optional<int> core_;            ///< the winding number in the core, where no surface is
  std::vector<Index> cell_groups_;     ///< where each cell's groups begin
  std::vector<Group> groups_;          ///< by cells, then by norm; the last three end the one before
  std::vector<Index> entries_;         ///< triangles of the covering, by groups
  std::vector<std::uint8_t> heights_;  ///< of each, in a group that is no sheet: above the `steps` of its norms
};

}  // namespace tetracone::tetratree

#endif
