// The extension module: errors, and the bindings of each subject.
#include <utility>

#include "exact/judge/judge.h"
#include "fuzz/files/corpus.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/plugin/supervisor.h"
#include "python/binding/common.h"
#include "python/binding/work.h"

namespace axiscert::python {

void bind_errors(py::module_& m) {
  // Those of the package: Error is a ValueError, HarnessFault a RuntimeError.
  static const py::handle errors = py::module_::import("axiscert._errors").release();
  m.attr("Error") = errors.attr("Error");
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      PyErr_SetString(errors.attr("Error").ptr(), error.what());
    } catch (const HarnessFault& fault) {
      PyErr_SetString(errors.attr("HarnessFault").ptr(), fault.what());
    }
  });
}

}  // namespace axiscert::python

PYBIND11_MODULE(_core, m) {
  using namespace axiscert::python;
  m.doc() = "The bindings of axiscert; the package has what is to be used.";
  bind_errors(m);
  bind_descriptions(m);
  bind_queries(m);
  bind_truth(m);
  bind_callables(m);
  bind_judge(m);
  bind_instruments(m);
  bind_formulae(m);
  bind_certified(m);
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_all_work));
  m.def("set_own_folder", [](const std::string& folder) { axiscert::set_own_folder(folder); });
  m.def("default_corpus_folder", &axiscert::default_corpus_folder);
  // Returns those before.
  m.def("set_plugin_seconds", [](double seconds) { return std::exchange(axiscert::plugin::batch_seconds, seconds); });
}
