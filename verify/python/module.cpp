// The harness in Python, as the module tetracone._verify; `tetracone.verify` is what users import.

#include "tetracone/tetratree/door/tetracone.h"
#include "tetracone/tetratree/python/arrays.h"
#include "tetracone/tetratree/python/texts.h"
#include "verify/cases/case_file.h"
#include "verify/families/families.h"
#include "verify/integer_truth/integer_truth.h"
#include "verify/shrink/shrink.h"

#include <pybind11/functional.h>
#include <pybind11/stl.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tetracone::verify {
namespace {

namespace py = pybind11;
using kernel::Question;

/// A case of two bodies and its question.
struct Asked {
  Object_case c;
  Question question;
};

Question asked_question(const py::str& of_name, const std::string& where)
{
  const std::string name = python::text_of(of_name);
  if (const auto question = kernel::parse_question(name)) return *question;
  throw Error(where + ": question '" + name + "'; expected solid or surface");
}

std::shared_ptr<const Polyhedron> checked(const py::handle& vertices, const py::handle& faces)
{
  return std::make_shared<Polyhedron>(Body(python::polyhedron_of(vertices, faces)).polyhedron());
}

Asked made(const py::handle& a_vertices, const py::handle& a_faces, const py::object& pose_a,
           const py::handle& b_vertices, const py::handle& b_faces, const py::object& pose_b, const py::str& question)
{
  Asked asked;
  asked.question = asked_question(question, "case");
  asked.c.a = checked(a_vertices, a_faces);
  asked.c.b = checked(b_vertices, b_faces);
  Query(Body(*asked.c.a), Body(*asked.c.b), asked.question);  // that solids are closed
  const auto one = [](const py::object& pose, const char* name) {
    const python::Poses poses(pose, name);
    if (!poses.is_one()) throw Error(std::string(name) + ": many poses; expected one, (3, 4) or (4, 4)");
    poses.require(0);
    return poses(0).exact();
  };
  asked.c.pose_a = one(pose_a, "pose_a");
  asked.c.pose_b = one(pose_b, "pose_b");
  return asked;
}

const Family& family(const py::str& of_name)
{
  const std::string name = python::text_of(of_name);
  if (const Family* const found = find_family(name)) return *found;
  throw Error("cases: no family '" + name + "'; expected one of tetracone.verify.families");
}

/// Numerators and denominators in hexadecimal: of decimals Python takes only short ones.
py::list ratios_of(const kernel::Pose& pose)
{
  py::list ratios;
  for (int k = 0; k < 12; ++k) {
    const kernel::Rational x = pose.exact(k);
    ratios.append(py::make_tuple(x.get_num().get_str(16), x.get_den().get_str(16)));
  }
  return ratios;
}

bool truth(const Asked& asked)
{
  const py::gil_scoped_release unlocked;
  const bool answer = true_answer(asked.c, asked.question);
  if (answer != integer_truth::collide(asked.c, asked.question))
    throw std::logic_error("the two truths disagree; tetracone verify says where");
  return answer;
}

/// A function of Python that says yes or no by a bool, by None that it declines, and by anything else that it fails.
class Python_subject : public Running_subject {
 public:
  Python_subject(py::function function, Question question) : function_(std::move(function)), question_(question) {}

  Outcome operator()(const Object_case& c, Question) override
  {
    const py::object answer = function_(Asked{c, question_});
    if (answer.is_none()) return Outcome::not_asked;
    if (!py::isinstance<py::bool_>(answer)) return Outcome::failed;
    return answer.cast<bool>() ? Outcome::yes : Outcome::no;
  }

 private:
  py::function function_;
  Question question_;
};

Asked shrunk(const Asked& asked, const py::function& function, double seconds, std::size_t evaluations)
{
  Python_subject subject(function, asked.question);
  const bool right = truth(asked);
  const Outcome answer = subject(asked.c, asked.question);
  if (answer == Outcome::not_asked)
    throw Error("shrink: the function declines this case; expected one that it gets wrong");
  if (answer != Outcome::failed && (answer == Outcome::yes) == right)
    throw Error("shrink: the function is right about this case; expected one that it gets wrong");
  const auto still = same_error(subject, asked.question, answer, right);
  return {shrink(asked.c, asked.question, still, {evaluations, seconds}), asked.question};
}

py::tuple case_of(const py::object& of_path)
{
  const std::filesystem::path path = python::path_of(of_path);
  const Case_file file = read_case(path);
  if (file.level != Case_kind::object)
    throw Error(path.native() + ": the case of a predicate; expected one of two bodies");
  py::list wrong;
  for (const Wrong& w : file.wrong) wrong.append(py::make_tuple(w.subject, w.answer));
  return py::make_tuple(Asked{*file.object, file.question}, bool(file.truth), std::move(wrong), file.cause);
}

std::string text_of(const Asked& asked, const std::vector<std::pair<std::string, std::optional<int>>>& wrong,
                    const std::string& cause)
{
  Case_file file;
  file.object = asked.c;
  file.question = asked.question;
  file.truth = truth(asked);
  file.object->surface = true_answer(asked.c, Question::surface);
  if (asked.question == Question::solid) file.object->solid = file.truth;
  for (const auto& [subject, answer] : wrong) file.wrong.push_back({subject, answer});
  file.cause = cause;
  file.version = TETRACONE_VERSION;
  return to_json(file);
}

}  // namespace
}  // namespace tetracone::verify

PYBIND11_MODULE(_verify, module)
{
  using namespace tetracone::verify;

  // The class of the other module: one `Error` for users.
  static const py::handle error = py::object(py::module_::import("tetracone._tetracone").attr("Error")).release();
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const tetracone::Error& e) {
      tetracone::python::set_error(error, e);
    }
  });

  py::class_<Asked>(module, "Asked")
      .def(py::init(&made))
      .def_property_readonly("question", [](const Asked& asked) { return std::string(to_string(asked.question)); })
      .def_property_readonly("origin",
                             [](const Asked& asked) {
                               const Origin& o = asked.c.origin;
                               return py::make_tuple(o.family, o.seed, o.index, o.parameter);
                             })
      .def("same_body", [](const Asked& asked, const Asked& other,
                           bool b) { return b ? asked.c.b == other.c.b : asked.c.a == other.c.a; })
      .def("body",
           [](const py::object& self, bool b) {
             const Asked& asked = self.cast<const Asked&>();
             const tetracone::Polyhedron& p = b ? *asked.c.b : *asked.c.a;
             return py::make_tuple(tetracone::python::vertices_of(p, self), tetracone::python::faces_of(p));
           })
      .def("pose", [](const Asked& asked, bool b) { return ratios_of(b ? asked.c.pose_b : asked.c.pose_a); });

  module.def("families", [] {
    py::dict all;
    for (const Family& family : families()) all[py::str(std::string(family.name))] = std::string(family.what);
    return all;
  });
  module.def("case_of", [](const py::str& name, std::uint64_t seed, std::uint64_t index, const py::str& question) {
    const auto asked = asked_question(question, "cases");
    return Asked{family(name).object_case(seed, index), asked};
  });
  module.def("truth", &truth);
  module.def("shrunk", &shrunk);
  module.def("read_case", &case_of);
  module.def("case_text", &text_of);
}
