#include "tetracone/tetratree/door/body_file.h"

#include "tetracone/covering/io/input_error.h"
#include "tetracone/covering/io/mapped_file.h"
#include "tetracone/covering/io/read.h"
#include "tetracone/covering/polyhedron.h"
#include "tetracone/tetratree/door/body_data.h"
#include "tetracone/tetratree/door/checksum.h"
#include "tetracone/tetratree/door/tree_flaw.h"
#include "tetracone/tetratree/fast/bvh8.h"
#include "tetracone/tetratree/fast/reserved_array.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace tetracone::detail {
namespace {

namespace fs = std::filesystem;
using covering::Face_triangle;
using covering::Index;
using covering::Input_error;
using covering::Polyhedron;
using tetratree::Bvh8_node;

/// The version of the format. It changes whenever arrays change their meaning: in elements, in nodes, in how boxes are
/// made.
constexpr std::uint32_t format_version = 2;

/// The alignment of the nodes in the file: a multiple of the page of any machine.
constexpr std::size_t page = 65536;

/// The number of arrays of a body; the nodes are the last.
constexpr std::size_t array_count = 7;

struct Array {
  std::uint64_t element_bytes, count;
  friend bool operator==(const Array&, const Array&) = default;
};

struct Header {
  std::array<char, 16> magic;
  std::uint32_t version, byte_order;
  std::array<Array, array_count> arrays;
  std::uint64_t checksum;  // of the file, with 0 in place of the checksum
  std::array<std::uint64_t, 6> nothing;
};
static_assert(sizeof(Header) % Checksum::block == 0 && offsetof(Header, checksum) == place_of_checksum);

constexpr Header header_of_this_machine{
    {'t', 'e', 't', 'r', 'a', 'c', 'o', 'n', 'e', ' ', 'b', 'o', 'd', 'y', '\n', '\0'},
    format_version,
    0x04030201,
    {},
    0,
    {}};

/// Calls what(array) for each array, in the order of the file. `order` is the order of the tree's elements.
template <class What>
void for_arrays(const Polyhedron& polyhedron, const std::vector<Face_triangle>& triangles,
                const std::vector<Index>& order, const std::vector<Bvh8_node>& nodes, const What& what)
{
  const auto as_span = [&](const auto& array) { what(std::span(array)); };
  polyhedron.for_arrays(as_span);
  as_span(triangles);
  as_span(order);
  as_span(nodes);
}

/// Returns the sizes and counts of the arrays of a body with these nodes.
std::array<Array, array_count> table(const Polyhedron& polyhedron, const std::vector<Face_triangle>& triangles,
                                     const std::vector<Index>& order, const std::vector<Bvh8_node>& nodes)
{
  std::array<Array, array_count> all;
  std::size_t k = 0;
  for_arrays(polyhedron, triangles, order, nodes, [&](const auto& array) {
    all.at(k++) = {sizeof(array[0]), array.size()};
  });
  return all;
}

std::uint64_t rounded_up(std::uint64_t bytes, std::uint64_t unit) { return (bytes + unit - 1) / unit * unit; }

/// Returns the byte at which array k begins, or the file's size for k = array_count.
std::uint64_t begin_of(const Header& header, std::size_t k)
{
  std::uint64_t at = sizeof(Header);
  for (std::size_t before = 0; before < k; ++before)
    at = rounded_up(at, before + 1 == array_count ? page : Checksum::block) +
         header.arrays[before].element_bytes * header.arrays[before].count;
  return k == array_count ? at : rounded_up(at, k + 1 == array_count ? page : Checksum::block);
}

/// A file under a temporary name. It becomes the file when all is written; otherwise it is removed.
class Temporary_output {
 public:
  explicit Temporary_output(const fs::path& file) : file_(file), temporary_(temporary_of(file))
  {
    errno = 0;
    out_.open(temporary_, std::ios::binary | std::ios::trunc);
    require_written();
  }
  ~Temporary_output()
  {
    std::error_code ignored;
    if (!is_done_) fs::remove(temporary_, ignored);
  }
  Temporary_output(const Temporary_output&) = delete;

  /// Writes bytes at `place`, behind all earlier ones, with zeros between. Requires that `place` is a multiple of a
  /// block.
  void append(std::uint64_t place, std::span<const std::byte> bytes)
  {
    const std::vector<std::byte> zeros(place - at_);
    write(zeros);
    sum_.add(std::span(zeros).subspan(rounded_up(at_, Checksum::block) - at_));
    write(bytes);
    sum_.add(bytes);
    at_ = place + bytes.size();
  }
  /// Writes bytes over the start of the file.
  void overwrite(std::span<const std::byte> bytes)
  {
    out_.seekp(0);
    write(bytes);
  }
  void finish()
  {
    out_.close();
    require_written();
    std::error_code error;
    fs::rename(temporary_, file_, error);
    if (error) refuse(error);
    is_done_ = true;
  }

  /// Returns the checksum of all that was appended.
  const Checksum& checksum() const { return sum_; }

 private:
  static fs::path temporary_of(const fs::path& file)
  {
    static std::atomic<unsigned> count = 0;
    return file.native() + ".part" + std::to_string(::getpid()) + "." + std::to_string(++count);
  }

  void write(std::span<const std::byte> bytes)
  {
    out_.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    require_written();
  }
  void require_written() const
  {
    if (!out_) refuse(std::error_code(errno, std::generic_category()));
  }
  [[noreturn]] void refuse(const std::error_code& why) const
  {
    throw Input_error(file_.native(), 0, "cannot be written" + (why ? ": " + why.message() : ""),
                      "expected a file in a folder that may be written");
  }

  fs::path file_, temporary_;
  std::ofstream out_;
  Checksum sum_;
  std::uint64_t at_ = 0;
  bool is_done_ = false;
};

/// Returns the header. Throws Input_error unless the bytes are a file that was saved.
Header checked_header(const fs::path& file, std::string_view bytes)
{
  const auto fail = [&](const std::string& wrong, const std::string& expected) {
    throw Input_error(file.native(), 0, wrong, "expected " + expected);
  };
  const Header& own = header_of_this_machine;
  if (bytes.empty()) fail("the file is empty", "a saved body");
  if (!bytes.starts_with(std::string_view(own.magic.data(), kernel::minimum(own.magic.size(), bytes.size()))))
    fail("is no saved body", "a file that `tetracone save` or save_body wrote");
  if (bytes.size() < sizeof(Header))
    fail("has " + std::to_string(bytes.size()) + " bytes",
         "at least the " + std::to_string(sizeof(Header)) + " with which a saved body begins");
  Header header;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.byte_order != own.byte_order)
    fail("is of a machine with another order of bytes", "a body saved by such a machine as this one");
  if (header.version != own.version)
    fail("is a saved body of version " + std::to_string(header.version),
         "version " + std::to_string(own.version) + ": save it anew");
  const auto sizes = table(Polyhedron(), {}, {}, {});
  bool fits = true;
  for (std::size_t k = 0; k < array_count; ++k) {
    if (header.arrays[k].element_bytes != sizes[k].element_bytes)
      fail("has " + std::to_string(header.arrays[k].element_bytes) + " bytes for an element of array " +
               std::to_string(k),
           std::to_string(sizes[k].element_bytes) + ": save it anew");
    fits = fits && header.arrays[k].count <= bytes.size() / sizes[k].element_bytes;  // no sum of these overflows
  }
  if (!fits || begin_of(header, array_count) != bytes.size())
    fail("has " + std::to_string(bytes.size()) + " bytes",
         (fits ? std::to_string(begin_of(header, array_count)) : "more") + ", as its beginning says");
  Header summed = header;
  summed.checksum = 0;
  Checksum sum;
  sum.add(std::as_bytes(std::span(&summed, 1)));
  sum.add(std::as_bytes(std::span(bytes)).subspan(begin_of(header, 0)));
  if (sum.value() != header.checksum)
    fail("is spoiled: its checksum is not that of its bytes", "the file as it was saved");
  return header;
}

}  // namespace

bool is_body_file(const fs::path& file) { return covering::suffix_of(file) == ".body"; }

void write_body_file(const Body_data& body, const fs::path& file)
{
  if (!is_body_file(file))
    throw Input_error(file.native(), 0, "no name of a saved body", "expected one that ends in .body");
  const tetratree::Bvh8& tree = body.bvh8();
  const std::vector<Bvh8_node> nodes = tree.nodes_in_order();
  const std::vector<Index> order = tree.elements().order_of(body.polyhedron, body.triangles);
  const auto for_all = [&](const auto& what) { return what(body.polyhedron, body.triangles, order, nodes); };
  Header header = header_of_this_machine;
  header.arrays = for_all([](const auto&... parts) { return table(parts...); });
  const auto header_bytes = std::as_bytes(std::span(&header, 1));

  Temporary_output out(file);
  out.append(0, header_bytes);
  std::size_t k = 0;
  for_all([&](const auto&... parts) {
    for_arrays(parts..., [&](const auto& array) { out.append(begin_of(header, k++), std::as_bytes(array)); });
  });
  header.checksum = out.checksum().value();
  out.overwrite(header_bytes);
  out.finish();
}

std::shared_ptr<const Body_data> read_body_file(const fs::path& file)
{
  covering::Mapped_file mapped(file);
  const Header header = checked_header(file, mapped.bytes());
  std::size_t k = 0;
  const auto fill = [&](auto& array) {
    using T = typename std::remove_reference_t<decltype(array)>::value_type;
    static_assert(std::is_trivially_copyable_v<T>);
    array.resize(header.arrays[k].count);
    if (!array.empty())
      std::memcpy(array.data(), mapped.bytes().data() + begin_of(header, k), array.size() * sizeof(T));
    ++k;
  };
  const auto fail = [&](const std::string& wrong) {
    throw Input_error(file.native(), 0, wrong, "expected a file that `tetracone save` or save_body wrote");
  };
  Polyhedron polyhedron;
  polyhedron.for_arrays(fill);
  if (!polyhedron.has_legal_loops()) fail("has loops of other corners, or faces of other loops, than there are");
  std::vector<Face_triangle> triangles;
  fill(triangles);
  triangles = legal_triangles(polyhedron, std::move(triangles), file.string());
  std::vector<Index> order;
  fill(order);
  tetratree::Bvh8_elements elements(polyhedron, triangles);
  if (!elements.put_in_order(order)) fail("has leaves that do not hold each triangle and each face once");
  // The nodes lie on mapped pages at a multiple of the largest page, so they are aligned.
  const std::uint64_t at = begin_of(header, k), count = header.arrays[k].count;
  const auto* const nodes = reinterpret_cast<const Bvh8_node*>(mapped.bytes().data() + at);
  if (const auto flaw = tree_flaw(elements, {nodes, count})) fail(*flaw);
  return std::make_shared<const Body_data>(
      std::move(polyhedron), std::move(triangles), std::move(elements),
      tetratree::Reserved_array<Bvh8_node>(static_cast<Bvh8_node*>(mapped.release_from(at)), count));
}

}  // namespace tetracone::detail
