#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <optional>

#include "base/errors.hpp"
#include "base/in_words.hpp"
#include "base/printable.hpp"
#include "output/folder/csv.hpp"
#include "output/folder/files.hpp"
#include "output/folder/text.hpp"
#include "runs/sweep.hpp"
#include "scene/rewrite.hpp"
#include "session.hpp"

/// `reye._reye`: what computes, for the package `reye` around it. The interpreter's lock is free while it computes.
namespace {

namespace py = pybind11;
using namespace reye;
using apps::Text;

/// A text of the program, whatever its bytes are.
py::str text_of(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "surrogateescape"));
}

py::list texts_of(const std::vector<std::string>& texts) {
  py::list all;
  for (const auto& text : texts) all.append(text_of(text));
  return all;
}

/// Raises reye.InputError with an entry per issue.
void raise_input_error(const base::InputError& error) {
  py::list issues;
  for (const auto& issue : error.issues())
    issues.append(py::make_tuple(base::printable(issue.key), base::printable(issue.value), base::printable(issue.rule),
                                 base::in_words(issue)));
  const py::object made = py::module_::import("reye.errors").attr("input_error")(error.what(), issues);
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
}

/// Asks Python, from a thread without the interpreter's lock, whether to stop; what is raised meanwhile is kept and
/// raised again once the program has put everything in order.
class Asking {
 public:
  /// Calls `ask` under the lock; it may throw py::error_already_set, and a result of true asks for a stop.
  template <class Ask>
  void call(const Ask& ask) {
    const py::gil_scoped_acquire lock;
    try {
      stopped_ = ask() || stopped_;
    } catch (py::error_already_set& error) {
      ++stops_;
      stopped_ = true;
      if (!raised_) raised_.emplace(error);
    }
  }

  /// Lets Python handle signals that have come, as Ctrl-C. The lock is asked for now and then only: other threads of
  /// Python may hold it for milliseconds.
  void handle_signals() {
    const auto now = clock::now();
    if (now - asked_at_ < std::chrono::milliseconds(20)) return;
    asked_at_ = now;
    call([] {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      return false;
    });
  }

  bool stopped() const { return stopped_; }
  int stops() const { return stops_; }  ///< how often something was raised
  void raise_again() const {
    if (raised_) throw py::error_already_set(*raised_);
  }

 private:
  using clock = std::chrono::steady_clock;
  clock::time_point asked_at_{};
  bool stopped_ = false;
  int stops_ = 0;
  std::optional<py::error_already_set> raised_;
};

/// The tables and the notes of a run. `callback`: called with the numbers of a block; True stops the run.
py::tuple run(const Text& scene, const apps::RunPlace& place, int threads, const py::object& callback) {
  Asking asking;
  apps::SessionWatch watch;
  watch.begins = [&] {  // nothing is written yet: what a signal raised meanwhile ends the run at once
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  };
  watch.block = [&](const apps::BlockEnd& at) {
    if (callback.is_none() || asking.stopped()) return;
    asking.call([&] {
      return callback(text_of(at.step), at.cycle, at.cycles, at.fraction, at.depth_max_mm, at.increments,
                      at.increments_left)
          .cast<bool>();
    });
  };
  watch.interrupted = [&] {
    asking.handle_signals();
    return asking.stopped();
  };
  apps::SessionRun session;
  {
    const py::gil_scoped_release unlocked;
    session = apps::run(scene, place, threads, watch);
  }
  asking.raise_again();
  py::dict tables;
  for (const auto& [file, text] : session.tables) tables[text_of(file)] = text_of(text);
  return py::make_tuple(tables, texts_of(session.notes));
}

py::dict plan(const Text& scene, double trial_s, int threads) {
  apps::SessionPlan made;
  {
    const py::gil_scoped_release unlocked;
    made = apps::plan(scene, trial_s, threads);
  }
  using namespace py::literals;
  return py::dict("lines"_a = texts_of(made.lines), "skipped"_a = texts_of(made.skipped),
                  "warnings"_a = texts_of(made.warnings), "in_words"_a = texts_of(made.in_words),
                  "forecast"_a = made.forecast);
}

py::tuple check(const Text& scene) {
  apps::SessionCheck made;
  {
    const py::gil_scoped_release unlocked;
    made = apps::check(scene);
  }
  return py::make_tuple(texts_of(made.lines), texts_of(made.warnings));
}

/// The members that are not done.
py::list sweep(const Text& scene, const std::vector<std::string>& vary, const std::string& out, int jobs, bool force) {
  Asking asking;
  apps::SweepRequest request;
  request.path = scene.path;
  request.text = scene.text;
  request.trust_geometry = scene.trust_geometry;
  request.vary = vary;
  request.out = out;
  request.jobs = jobs;
  request.force = force;
  const apps::SweepWatch watch{nullptr, [&] {
                                 asking.handle_signals();
                                 return asking.stops();
                               }};
  apps::SweepResult result;
  {
    const py::gil_scoped_release unlocked;
    result = apps::sweep(request, watch);
  }
  asking.raise_again();
  return texts_of(result.undone);
}

/// The folder of the results, and warnings.
py::tuple calibrate(const Text& scene, const apps::CalibrateRequest& request, int threads) {
  Asking asking;
  apps::SessionCalibration session;
  {
    const py::gil_scoped_release unlocked;
    session = apps::calibrate(scene, request, threads, [&] {
      asking.handle_signals();
      return asking.stopped();
    });
  }
  asking.raise_again();
  return py::make_tuple(text_of(session.dir), text_of(session.failure), texts_of(session.warnings));
}

/// Columns by name: the bytes of its numbers as doubles, or a list of texts.
py::dict columns(const std::string& csv) {
  py::dict all;
  for (const auto& column : apps::columns_of(csv))
    if (column.texts.empty())
      all[text_of(column.name)] =
          py::bytes(reinterpret_cast<const char*>(column.numbers.data()), column.numbers.size() * sizeof(double));
    else
      all[text_of(column.name)] = texts_of(column.texts);
  return all;
}

}  // namespace

PYBIND11_MODULE(_reye, m) {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const base::InputError& error) {
      raise_input_error(error);
    }
  });
  py::class_<Text>(m, "Text")
      .def(py::init([](std::string text, std::string path, bool trust) {
        return Text{std::move(text), std::move(path), trust};
      }))
      .def("read", &apps::read);
  m.def("run", [](const Text& scene, const std::string& dir, bool restart, bool force, int threads,
                  const py::object& callback) {
    return run(scene, {dir, restart, force}, threads, callback);
  });
  m.def("plan", &plan);
  m.def("check", &check);
  m.def("sweep", &sweep);
  m.def("calibrate",
        [](const Text& scene, const std::string& measured, const std::vector<std::string>& free, double at,
           const std::string& contact, const std::string& side, const std::string& out, bool force, int threads) {
          return calibrate(scene, {measured, free, at, contact, side, out, force}, threads);
        });
  m.def("columns", &columns);
  m.def("cells", [](const std::string& line) { return texts_of(output::csv_cells(line)); });
  m.def("file_part", [](const std::string& name) { return text_of(output::file_part(name)); });
  m.def("rule_of_key",
        [](const Text& scene, const std::string& key) { return text_of(apps::rule_of_key(scene, key)); });
  m.def("text_with", [](const Text& scene, const std::string& key, const std::string& value) {
    return text_of(apps::text_with(scene, key, value));
  });
  m.def("with_absolute_paths",
        [](const Text& scene) { return text_of(scene::with_absolute_paths(scene.text, scene.path)); });
  m.def("write", [](const std::string& path, const std::string& text) { output::atomic_write(path, text); });
  m.attr("version") = output::version;
}
