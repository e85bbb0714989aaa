#ifndef TETRACONE_KERNEL_PREDICATE_ADAPTIVE_FIXED_H
#define TETRACONE_KERNEL_PREDICATE_ADAPTIVE_FIXED_H

#include "tetracone/kernel/number/fixed_integer.h"
#include "tetracone/kernel/number/pose.h"
#include "tetracone/kernel/predicate/adaptive_points.h"
#include "tetracone/kernel/predicate/kept_images.h"

#include <CGAL/enum.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

namespace tetracone::kernel {

/// The fixed stage: the expression in integers of a fixed width, exactly and without allocation. Images are whole
/// multiples of one power of two. A sign is undecided only where they are too wide for that: where exponents are far
/// apart, or fractions have many digits. It takes no longer than in double-double.
class Adaptive_fixed : public Adaptive_points {
 public:
  /// The largest number of bits of a coordinate, once all points have one exponent, at which signs are computed. See
  /// `most_bits_of`.
  static constexpr int most_bits = 253;

  /// Returns the sign of det[b-a, c-a, d-a], exactly, or undecided where the images are too wide.
  static Decision fixed_volume_sign(const Point_3& a, const Point_3& b, const Point_3& c, const Point_3& d)
  {
    return Aligned<4>({&a, &b, &c, &d}).decide([](const auto& p) { return Plane(p).side(p[3]); });
  }

  /// Returns the signs of det[b-a, c-a, d_k-a] for three points, by one normal of the plane; nothing where the images
  /// are too wide.
  static std::optional<std::array<CGAL::Sign, 3>> fixed_sides(const Point_3& a, const Point_3& b, const Point_3& c,
                                                              const std::array<const Point_3*, 3>& d)
  {
    return Aligned<6>({&a, &b, &c, d[0], d[1], d[2]}).decide([](const auto& p) {
      const Plane plane(p);
      return std::array{plane.side(p[3]), plane.side(p[4]), plane.side(p[5])};
    });
  }

  /// Returns the sign of (b-a) x (c-a) in the component `axis`, exactly, or undecided.
  static Decision fixed_normal_sign(const Point_3& a, const Point_3& b, const Point_3& c, int axis)
  {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    return Aligned<3>({&a, &b, &c}).decide([i, j](const auto& p) {
      return sign((p[1][i] - p[0][i]) * (p[2][j] - p[0][j]) - (p[1][j] - p[0][j]) * (p[2][i] - p[0][i]));
    });
  }

  /// Returns the sign of a[axis] - b[axis], exactly, or undecided.
  static Decision fixed_difference_sign(const Point_3& a, const Point_3& b, int axis)
  {
    return Aligned<2>({&a, &b}).decide([axis](const auto& p) { return sign(p[0][axis] - p[1][axis]); });
  }

  /// Upper bound of the components of a direction that `fixed_sign_along` takes.
  static constexpr int longest_direction = 1023;

  /// Returns the sign of d . (b - a), exactly, or undecided. Requires |d[k]| <= `longest_direction`. A product has a
  /// limb more than a difference, so that the sum fits.
  static Decision fixed_sign_along(const Point_3& a, const Point_3& b, const std::array<int, 3>& d)
  {
    return Aligned<2>({&a, &b}).decide([&d](const auto& p) {
      const auto part = [&](int k) { return (p[1][k] - p[0][k]) * Fixed_integer<1>(d[k]); };
      return sign(part(0) + part(1) + part(2));
    });
  }

 private:
  template <int limbs>
  static CGAL::Sign sign(const Fixed_integer<limbs>& x)
  {
    return CGAL::Sign(x.sign());
  }

  template <int limbs>
  using Coordinates = std::array<Fixed_integer<limbs>, 3>;

  /// The plane of the first three of some points, which must outlive it.
  template <int limbs>
  class Plane {
   public:
    template <std::size_t count>
    explicit Plane(const std::array<Coordinates<limbs>, count>& p) : origin_(p[0])
    {
      const Coordinates<limbs> u = from_origin(p[1]), v = from_origin(p[2]);
      const auto minor = [&](int i, int j) { return u[i] * v[j] - u[j] * v[i]; };
      normal_ = {minor(1, 2), minor(2, 0), minor(0, 1)};
    }
    CGAL::Sign side(const Coordinates<limbs>& point) const
    {
      const Coordinates<limbs> w = from_origin(point);
      return sign(normal_[0] * w[0] + normal_[1] * w[1] + normal_[2] * w[2]);
    }

   private:
    Coordinates<limbs> from_origin(const Coordinates<limbs>& p) const
    {
      return {p[0] - origin_[0], p[1] - origin_[1], p[2] - origin_[2]};
    }

    const Coordinates<limbs>& origin_;
    Coordinates<2 * limbs> normal_;
  };
  template <int limbs, std::size_t count>
  Plane(const std::array<std::array<Fixed_integer<limbs>, 3>, count>&) -> Plane<limbs>;

  /// Images times the same positive factor: the odd parts of all weights of the poses, each once, and a power of two.
  /// An image already has its own weight.
  template <std::size_t count>
  class Aligned {
   public:
    explicit Aligned(const std::array<const Point_3*, count>& points)
    {
      std::array<int, count> exponent, bits;
      int lowest = Binary_number<1>::too_wide;
      for (std::size_t n = 0; n < count; ++n) {
        image_[n] = &kept_fixed_image(*points[n], n);
        const Binary_number<1>& own = weight_of(*points[n]);
        own_[n] = own.integer.limb[0];
        exponent[n] = image_[n]->exponent - own.exponent;
        bits[n] = image_[n]->bits;
        if (bits[n] == 0) continue;  // the origin, of any exponent and weight
        if (own.bits == Binary_number<1>::too_wide) bits[n] = own.bits;
        if (own_[n] != 1 && !is_among_weights(own_[n])) weight_[weight_count_++] = own_[n];
        lowest = minimum(lowest, exponent[n]);
      }
      for (std::size_t n = 0; n < count; ++n) {
        if (bits[n] == 0) continue;
        shift_[n] = exponent[n] - lowest;
        int all = bits[n] + shift_[n];
        for (std::size_t w = 0; w < weight_count_; ++w)
          if (lacks(n, w)) all += int(std::bit_width(weight_[w]));
        bits_ = maximum(bits_, all);
      }
    }

    /// Returns what `question` answers of the images; nothing where these are too wide for its products, which have at
    /// most three factors: differences of coordinates.
    template <class Question>
    auto decide(const Question& question) const
        -> std::optional<decltype(question(std::array<Coordinates<1>, count>()))>
    {
      if (bits_ <= most_bits_of<1>) return question(images<1>());
      if (bits_ <= most_bits_of<2>) {
        const auto p = images<2>();
        if (const auto near = from_first(p)) return question(*near);
        return question(p);
      }
      if (bits_ <= most_bits_of<3>) return question(images<3>());
      if (bits_ <= most_bits) return question(images<Fixed_image::limbs>());
      return std::nullopt;
    }

   private:
    /// The largest number of bits of coordinates for which products fit in three times `limbs` limbs. A difference has
    /// one bit more, the sum of six products of three differences three more, and the sign another.
    template <int limbs>
    static constexpr int most_bits_of = (3 * 64 * limbs - 4) / 3 - 1;
    static_assert(most_bits <= most_bits_of<Fixed_image::limbs>);

    template <int limbs>
    std::array<Coordinates<limbs>, count> images() const
    {
      const auto coordinate = [this](std::size_t n, int k) {
        Fixed_integer<limbs> x(image_[n]->coordinate[k]);
        for (std::size_t w = 0; w < weight_count_; ++w)
          if (lacks(n, w)) x = Fixed_integer<limbs>(x * Fixed_integer<1>(std::int64_t(weight_[w])));
        return shift_[n] != 0 ? x << shift_[n] : x;
      };
      // At once: otherwise the numbers would be made 0 before.
      return [&]<std::size_t... n>(std::index_sequence<n...>)
      {
        return std::array{Coordinates<limbs>{coordinate(n, 0), coordinate(n, 1), coordinate(n, 2)}...};
      }
      (std::make_index_sequence<count>());
    }

    /// Returns the points moved so that the first is the origin, which changes no difference; nothing where one limb is
    /// too narrow for that. Points near one another fit, however far they are from the origin of their frame.
    static std::optional<std::array<Coordinates<1>, count>> from_first(const std::array<Coordinates<2>, count>& p)
    {
      constexpr int most_of_difference = most_bits_of<1> + 1;
      std::array<Coordinates<1>, count> near;
      bool fit = true;
      for (std::size_t n = 0; n < count; ++n)
        for (int k = 0; k < 3; ++k) {
          const Fixed_integer<2> difference = p[n][k] - p[0][k];
          fit &= difference.modulo() + (Uint128(1) << most_of_difference) <= Uint128(2) << most_of_difference;
          near[n][k] = Fixed_integer<1>(difference);
        }
      return fit ? std::optional(near) : std::nullopt;
    }

    bool is_among_weights(std::uint64_t weight) const
    {
      for (std::size_t w = 0; w < weight_count_; ++w)
        if (weight_[w] == weight) return true;
      return false;
    }
    bool lacks(std::size_t n, std::size_t w) const { return own_[n] != weight_[w]; }

    std::array<const Fixed_image*, count> image_;
    std::array<std::uint64_t, count> own_;     // the odd part of the weight that an image has
    std::array<std::uint64_t, count> weight_;  // the first `weight_count_`: the different ones but 1
    std::size_t weight_count_ = 0;
    std::array<int, count> shift_{};
    int bits_ = 0;
  };

  static const Binary_number<1>& weight_of(const Point_3& point)
  {
    static const Binary_number<1> one{Fixed_integer<1>(1), 0, 1};
    return point.pose != nullptr && point.pose->is_rational() ? point.pose->binary_weight() : one;
  }

  /// Returns the image of a point, which its slot keeps. Without a slot, place n keeps it until the next sign.
  static const Fixed_image& kept_fixed_image(const Point_3& point, std::size_t n)
  {
    if (point.slot == nullptr) return fixed_image_at(n, point);
    std::optional<Fixed_image>& image = kept(point).fixed;
    if (!image) image.emplace(Made_in_place{point});
    return *image;
  }
  [[gnu::noinline]] static const Fixed_image& fixed_image_at(std::size_t n, const Point_3& point)
  {
    static thread_local std::array<Fixed_image, 6> images;
    return images[n] = fixed_image(point);
  }

  /// Makes an image where it is kept: a copy would stall on store forwarding.
  struct Made_in_place {
    const Point_3& point;
    operator Fixed_image() const { return fixed_image(point); }
  };

  static Fixed_image fixed_image(const Point_3& point)
  {
    const auto unmoved = [](const Vertex& vertex) {
      const auto v = fixed_numbers(vertex);
      Fixed_image image{{}, v.exponent, v.bits};
      for (int k = 0; k < 3; ++k) image.coordinate[k] = Fixed_integer<Fixed_image::limbs>(v.integer[k]);
      return image;
    };
    if (point.pose == nullptr) return unmoved(point.vertex);
    if (point.error == 0) return unmoved(point.image);
    return moved(point.vertex, map_of(*point.pose));
  }

  /// Returns the map of a pose. A map of doubles is made once while the thread asks for two poses in turn.
  static const Fixed_map& map_of(const Pose& pose)
  {
    struct Made {
      std::array<double, 12> entries{};
      Fixed_map map;
    };
    static thread_local std::array<Made, 2> made;
    static thread_local std::size_t last = 0;
    if (pose.is_rational()) return pose.fixed_map();
    const auto is_of_pose = [&pose](const Made& map) {
      const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
      std::uint64_t differ = 0;
      for (std::size_t k = 0; k < 12; ++k) differ |= bits(map.entries[k]) ^ bits(pose.entries()[k]);
      return differ == 0;
    };
    if (!is_of_pose(made[last])) {
      last = 1 - last;
      if (!is_of_pose(made[last])) {
        made[last].entries = pose.entries();
        std::construct_at(&made[last].map, pose.entries());
      }
    }
    return made[last].map;
  }

  static Fixed_image moved(const Vertex& vertex, const Fixed_map& map)
  {
    using Number = Fixed_integer<Fixed_image::limbs>;
    const Fixed_numbers<3> v = fixed_numbers(vertex);
    const Fixed_numbers<9>& m = map.matrix;
    const Fixed_numbers<3>& t = map.translation;
    // A row is a sum of four terms, below four times the largest.
    const int of_products = m.exponent + v.exponent;
    const int lowest = t.bits == 0 ? of_products : v.bits == 0 ? t.exponent : minimum(of_products, t.exponent);
    const int shift = v.bits == 0 ? 0 : of_products - lowest, shift_t = t.bits == 0 ? 0 : t.exponent - lowest;
    Fixed_image image{{}, lowest, maximum(v.bits == 0 ? 0 : m.bits + v.bits + shift, t.bits + shift_t) + 2};
    if (image.bits > most_bits) return image;
    // Three products of one limb each fit in two.
    const bool is_narrow = m.bits <= 62 && v.bits <= 62;
    if (image.bits < 128) {  // modulo 2^128, where intermediate results may not fit
      for (int k = 0; k < 3; ++k) {
        const auto term = [&](int j) {
          const auto &entry = m.integer[3 * k + j], &x = v.integer[j];
          return is_narrow ? Uint128(Int128(std::int64_t(entry.limb[0])) * std::int64_t(x.limb[0]))
                           : entry.modulo() * x.modulo();
        };
        const Uint128 products = term(0) + term(1) + term(2);
        image.coordinate[k] = Number::of((products << shift) + (t.integer[k].modulo() << shift_t));
      }
      return image;
    }
    for (int k = 0; k < 3; ++k) {
      const auto term = [&](int j) { return Number(m.integer[3 * k + j] * v.integer[j]); };
      const auto narrow_term = [&](int j) {
        return Fixed_integer<1>(m.integer[3 * k + j]) * Fixed_integer<1>(v.integer[j]);
      };
      Number& x = image.coordinate[k];
      x = is_narrow ? Number(narrow_term(0) + narrow_term(1) + narrow_term(2)) : term(0) + term(1) + term(2);
      x = (x << shift) + (Number(t.integer[k]) << shift_t);
    }
    return image;
  }
};

}  // namespace tetracone::kernel

#endif
