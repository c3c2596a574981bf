#include "python/binding/callables.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "kernel/base/error.h"
#include "kernel/base/stopwatch.h"

namespace axiscert::python {

using plugin::Outputs;

Callable::Callable(Layout layout, bool records_errors, const ShownAnswers& shown, std::string id)
    : layout_(layout), records_errors_(records_errors), shown_(shown), id_(std::move(id)) {}

namespace {

// Found anew each time: a static's first use by two threads would wait for each other's lock.
py::module_ numpy() { return py::module_::import("numpy"); }

// Aligned, as a processor reads numbers: NumPy has arrays that are not.
template <class Value>
using Read = py::array_t<Value, py::array::forcecast | int{py::detail::npy_api::NPY_ARRAY_ALIGNED_}>;

// The text of any object, whatever its own methods do, and with what is no UTF-8 as escapes.
std::string text_of(const py::handle& object) {
  const auto made = py::reinterpret_steal<py::object>(PyObject_Str(object.ptr()));
  const auto bytes = py::reinterpret_steal<py::object>(
      made ? PyUnicode_AsEncodedString(made.ptr(), "utf-8", "backslashreplace") : nullptr);
  if (bytes) return py::reinterpret_borrow<py::bytes>(bytes);
  PyErr_Clear();
  return "(which has no text)";
}

// In a process that the function has forked, whose other threads are gone, nothing is to go on.
[[noreturn]] void end_forked(int code, const std::string& what) {
  if (!what.empty()) std::fprintf(stderr, "axiscert: %s\n", what.c_str());
  for (const char* const name : {"stdout", "stderr"}) {
    const py::object stream = py::module_::import("sys").attr(name);
    const auto flushed = py::reinterpret_steal<py::object>(PyObject_CallMethod(stream.ptr(), "flush", nullptr));
    PyErr_Clear();
  }
  std::_Exit(code);
}

// sys.exit() of a forked process ends it with its code, another exception with that of a fault.
[[noreturn]] void end_forked(const py::error_already_set& raised, const std::string& what) {
  if (!raised.matches(PyExc_SystemExit))
    end_forked(70, fmt::format("a kernel's function raised {} in a process that it forked", what));
  const py::object code = raised.value().attr("code");
  if (code.is_none()) end_forked(0, "");
  if (PyLong_Check(code.ptr())) end_forked(static_cast<int>(PyLong_AsLong(code.ptr())), "");
  end_forked(1, text_of(code));
}

}  // namespace

void Callable::refuse(const std::string& what) const { throw Error(fmt::format("kernel {}: {}", id_, what)); }

template <class Real>
py::object Callable::result_of(const py::object& kernel, const QueryColumns<Real>& batch, py::array_t<Real>& numbers) {
  const py::object function = kernel.attr("_function"), convert = kernel.attr("_tensors");
  const auto size = static_cast<py::ssize_t>(batch.size), item = static_cast<py::ssize_t>(sizeof(Real));
  numbers = py::array_t<Real>({static_cast<py::ssize_t>(batch.count), size});
  Real* const data = numbers.mutable_data();
  for (std::size_t k = 0; k < batch.count; ++k) std::copy_n(batch.column[k], batch.size, data + k * batch.size);
  // A library of tensors takes no memory that may not be written; what it writes is its own.
  const bool is_converted = !convert.is_none();
  if (!is_converted) numbers.attr("setflags")(py::arg("write") = false);
  // Warnings go in this thread alone: queries that overflow are asked on purpose.
  numpy().attr("seterr")(py::arg("all") = "ignore");
  const auto given = [&](py::object array) { return is_converted ? convert(array) : array; };
  if (layout_ == Layout::columns) return function(given(numbers));
  const PredicateEntry& entry = shown_.predicate->entries[shown_.entry];
  const std::vector<ColumnGroup> groups = groups_of(entry);
  py::tuple arguments(groups.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto width = static_cast<py::ssize_t>(groups[g].size);
    const Real* const at = data + groups[g].first * batch.size;
    if (width == 1) arguments[g] = given(py::array_t<Real>({size}, {item}, at, numbers));
    else arguments[g] = given(py::array_t<Real>({size, width}, {item, size * item}, at, numbers));
  }
  return function(*arguments);
}

py::array Callable::array_of(const py::handle& given, const std::string& what, std::size_t size,
                             std::size_t width) const {
  py::object made;
  try {
    made = py::isinstance<py::array>(given) || py::hasattr(given, "__array__") || !py::hasattr(given, "__dlpack__")
               ? numpy().attr("asarray")(given)
               : numpy().attr("from_dlpack")(given);
  } catch (const py::error_already_set& raised) {
    if (!raised.matches(PyExc_Exception)) throw;
    refuse(fmt::format("its {} are {}, of which NumPy makes no array: {}", what,
                       text_of(py::type::of(given).attr("__name__")), text_of(raised.value())));
  }
  py::array array = py::reinterpret_borrow<py::array>(made);
  if (py::isinstance(given, numpy().attr("ma").attr("MaskedArray")))
    refuse(fmt::format("its {} are a masked array; give each query an answer", what));
  if (array.ndim() == 0) {
    refuse(fmt::format("its {} are {}, no array; give shape ({}{})", what,
                       text_of(py::type::of(given).attr("__name__")), size,
                       width == 1 ? std::string(",") : fmt::format(", {}", width)));
  }
  const bool fits = width == 1 ? array.ndim() == 1 : array.ndim() == 2 && array.shape(1) == py::ssize_t(width);
  if (!fits || static_cast<std::size_t>(array.shape(0)) != size) {
    refuse(fmt::format("its {} have shape {}, of {} queries; give shape {}", what, text_of(array.attr("shape")), size,
                       width == 1 ? fmt::format("({},)", size) : fmt::format("({}, {})", size, width)));
  }
  return array;
}

void Callable::read_verdicts(const py::handle& given, std::size_t size, std::vector<std::uint8_t>& verdicts,
                             std::vector<std::uint64_t>& bits) const {
  py::array array = array_of(given, "verdicts", size, 1);
  const char kind = array.dtype().kind();
  const auto item = array.itemsize();
  verdicts.resize(size);
  if (shown_.has_bits && kind == 'u' && item >= 4) {
    const auto words = Read<std::uint64_t>::ensure(array);
    const auto at = words.unchecked<1>();
    bits.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      bits[i] = at(static_cast<py::ssize_t>(i));
      verdicts[i] = static_cast<std::uint8_t>(verdict_of(*shown_.predicate, bits[i]));
    }
    return;
  }
  if (shown_.has_bits || (kind != 'b' && !(kind == 'u' && item == 1))) {
    refuse(fmt::format(
        "its {} are {}; give {}", shown_.has_bits ? "comparison bits" : "verdicts", text_of(array.dtype()),
        shown_.has_bits ? "uint32 or uint64, bit i for comparison i"
                        : "bool, where True is contact, or uint8, where 0 is contact, 1 separated, 2 undecided and 3 "
                          "invalid; comparison bits take formulae="));
  }
  const auto bytes = Read<std::uint8_t>::ensure(array);
  const auto at = bytes.unchecked<1>();
  const std::uint8_t flip = kind == 'b' ? 1 : 0;  // contact is 0
  for (std::size_t i = 0; i < size; ++i) verdicts[i] = at(static_cast<py::ssize_t>(i)) ^ flip;
}

template <class Real>
Outputs<Real> Callable::read(const py::object& result, std::size_t size) const {
  Outputs<Real> out;
  if (!py::isinstance<py::dict>(result)) {
    if (shown_.measure_count != 0)
      refuse(fmt::format(
          "it returns {}; with measures= it returns a dictionary: \"verdict\", and each measure by its name",
          text_of(py::type::of(result).attr("__name__"))));
    read_verdicts(result, size, out.verdicts, out.bits);
    return out;
  }
  // A copy: reading a value may run code of its own, which may change the dictionary.
  const auto answers = py::reinterpret_steal<py::dict>(PyDict_Copy(result.ptr()));
  if (!answers.contains("verdict")) refuse("the dictionary that it returns has no \"verdict\"");
  read_verdicts(answers["verdict"], size, out.verdicts, out.bits);
  const auto& measures = shown_.predicate->measures;
  out.measures.assign(shown_.measure_count, std::vector<Real>(size, std::numeric_limits<Real>::quiet_NaN()));
  const auto take = [&](const py::array& array, std::size_t m, py::ssize_t place) {
    const char kind = array.dtype().kind();
    if (std::string_view("biuf").find(kind) == std::string_view::npos ||
        (kind == 'f' && array.itemsize() > static_cast<py::ssize_t>(sizeof(Real)))) {
      refuse(fmt::format("its numbers of {} are {}; give numbers, as {}", measures[m].name,
                         std::string(py::str(array.dtype())), std::string(py::str(py::dtype::of<Real>()))));
    }
    const auto numbers = Read<Real>::ensure(array);
    const auto* const base =
        reinterpret_cast<const char*>(numbers.data()) + (numbers.ndim() == 2 ? place * numbers.strides(1) : 0);
    for (std::size_t i = 0; i < size; ++i)
      out.measures[m][i] = *reinterpret_cast<const Real*>(base + static_cast<py::ssize_t>(i) * numbers.strides(0));
  };
  for (const auto& [key, value] : answers) {
    const std::string named = text_of(key);
    if (named == "verdict") continue;
    bool is_taken = false;
    for (std::size_t m = 0; m < shown_.measure_count; ++m) {
      if (measures[m].name == named) {
        take(array_of(value, "numbers of " + named, size, 1), m, 0);
        is_taken = true;
      } else if (measures[m].name == named + "_x") {  // a vector: three measures after each other
        if (m + 3 > shown_.measure_count) break;
        const py::array vectors = array_of(value, "numbers of " + named, size, 3);
        for (py::ssize_t axis = 0; axis < 3; ++axis) take(vectors, m + static_cast<std::size_t>(axis), axis);
        is_taken = true;
      }
    }
    if (is_taken) continue;
    std::string known;
    for (std::size_t m = 0; m < shown_.measure_count; ++m) known += fmt::format(", {}", measures[m].name);
    refuse(fmt::format("the dictionary that it returns has \"{}\"; it may have: verdict{}", named, known));
  }
  return out;
}

template <class Real>
Outputs<Real> Callable::ask(const QueryColumns<Real>& batch) {
  const py::gil_scoped_acquire lock;
  const py::object kernel = kernel_.is_none() ? kernel_ : kernel_();
  if (kernel.is_none()) refuse("its function was let go with the record that it was judged for");
  if (is_abandoned_) throw CallableFailed("interrupted");
  py::array_t<Real> numbers;
  const pid_t process = getpid();
  try {
    Stopwatch watch;
    const py::object result = result_of(kernel, batch, numbers);
    if (getpid() != process)
      end_forked(70, "a kernel's function returned in a process that it forked; end that with os._exit()");
    seconds_ += watch.lap() * 1e-9;
    ++calls_;
    return read<Real>(result, batch.size);
  } catch (const Error& refused) {
    kernel.attr("_raised") = py::make_tuple(py::none(), numbers, std::string(refused.what()));
  } catch (py::error_already_set& raised) {
    const bool is_to_end = !raised.matches(PyExc_Exception);
    const std::string what = fmt::format("{}: {}", text_of(raised.type().attr("__name__")), text_of(raised.value()));
    if (getpid() != process) end_forked(raised, what);
    py::object value = raised.value();
    if (raised.trace()) value.attr("__traceback__") = raised.trace();
    if (records_errors_ && !is_to_end) throw CallableFailed(what);
    kernel.attr("_raised") = py::make_tuple(value, numbers, fmt::format("kernel {}: it raised {}", id_, what));
    if (!is_to_end) throw CallableFailed("raised");
  }
  throw AnswerRefused("refused");
}
template Outputs<float> Callable::ask(const QueryColumns<float>&);
template Outputs<double> Callable::ask(const QueryColumns<double>&);

namespace {

constexpr int most_told = 16;  // exceptions of one unit

template <class Real>
QueryColumns<Real> part_of(const QueryColumns<Real>& batch, std::size_t first, std::size_t size) {
  QueryColumns<Real> part = batch;
  part.size = size;
  for (std::size_t k = 0; k < batch.count; ++k) part.column[k] = batch.column[k] + first;
  return part;
}

// Asks one function for one unit, and looks for what else is wrong with it.
template <class Real>
class AskedFunction {
 public:
  explicit AskedFunction(std::shared_ptr<Callable> callable) : callable_(std::move(callable)) {}

  void ask(const QueryColumns<Real>& batch, Verdict* out, Answers<Real>* answers, Watched* watched) {
    if (batch.size == 0) return;
    Outputs<Real> said;
    try {
      said = callable_->ask(batch);
    } catch (const AnswerRefused&) {
      throw;
    } catch (const CallableFailed&) {
      if (!callable_->records_errors() || callable_->is_abandoned()) throw;
      return ask_singly(batch, out, answers, watched);
    }
    take(said, 0, batch.size, out, answers, watched);
    if (watched == nullptr || !is_first_) return;
    is_first_ = false;
    try {
      rearrange(batch, said, *watched);
    } catch (const AnswerRefused&) {
      throw;
    } catch (const CallableFailed& raised) {
      if (!callable_->records_errors() || callable_->is_abandoned()) throw;
      tell(watched, FindingKind::crash, 0, fmt::format("it raised {}, asked the same again", raised.what()));
    }
  }

 private:
  void take(const Outputs<Real>& said, std::size_t first, std::size_t size, Verdict* out, Answers<Real>* answers,
            Watched* watched) {
    const ShownAnswers& shown = callable_->shown();
    for (std::size_t i = 0; i < size; ++i) {
      const bool is_one = plugin::is_verdict(said.verdicts[i]);
      out[first + i] = is_one ? static_cast<Verdict>(said.verdicts[i]) : Verdict::unanswered;
      if (!is_one)
        tell(watched, FindingKind::inconsistent, first + i, "verdict " + plugin::verdict_text(said.verdicts[i]));
      const ComparisonBits beyond = shown.has_bits ? said.bits[i] & ~all_comparisons(*shown.predicate) : 0;
      if (beyond != 0) {
        out[first + i] = Verdict::unanswered;
        tell(watched, FindingKind::inconsistent, first + i,
             fmt::format("its comparison bit {} is 1; there are comparisons 0 to {}", std::countr_zero(beyond),
                         shown.predicate->comparisons.size() - 1));
      }
    }
    if (answers == nullptr) return;
    if (shown.has_bits)
      std::copy_n(said.bits.begin(), size, answers->bits.begin() + static_cast<std::ptrdiff_t>(first));
    for (std::size_t m = 0; m < shown.measure_count; ++m)
      std::copy_n(said.measures[m].begin(), size, answers->measures[m].begin() + static_cast<std::ptrdiff_t>(first));
  }

  // The function raised: each query alone, so that the ones are found that it raises for.
  void ask_singly(const QueryColumns<Real>& batch, Verdict* out, Answers<Real>* answers, Watched* watched) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      out[i] = Verdict::unanswered;
      try {
        take(callable_->ask(part_of(batch, i, 1)), i, 1, out, answers, watched);
      } catch (const AnswerRefused&) {
        throw;
      } catch (const CallableFailed& raised) {
        if (callable_->is_abandoned()) throw;
        if (told_raised_++ < most_told)
          tell(watched, FindingKind::crash, i, fmt::format("it raised {}", raised.what()));
      }
    }
  }

  // The same again, in the other order, and in parts: a function of the query alone answers the same.
  void rearrange(const QueryColumns<Real>& batch, const Outputs<Real>& said, Watched& watched) {
    const Predicate& predicate = *callable_->shown().predicate;
    const auto again = [&](const QueryColumns<Real>& queries) { return verdicts_alone(callable_->ask(queries)); };
    const Outputs<Real> first = verdicts_alone(said);
    watched.asked_again += batch.size;
    if (const auto changed = plugin::first_difference(predicate, first, 0, again(batch))) {
      tell(&watched, FindingKind::nondeterministic, changed->query, changed->detail + " for the same batch");
      return;
    }
    if (batch.size < 2) return;
    QueryBatch<Real> reversed(batch.size, batch.count);
    for (std::size_t i = batch.size; i-- > 0;) reversed.push_back(query_at(batch, i));
    const Outputs<Real> backwards = again(reversed.columns());
    watched.asked_again += batch.size;
    for (std::size_t i = 0; i < batch.size; ++i) {
      const auto changed = plugin::difference_at(predicate, first, i, backwards, batch.size - 1 - i);
      if (!changed) continue;
      tell(&watched, FindingKind::order_dependent, i, *changed + " in the reversed batch");
      return;
    }
    const std::size_t begin = batch.size / 3, size = batch.size / 2;
    if (size == 0) return;
    watched.asked_again += size;
    if (const auto changed = plugin::first_difference(predicate, first, begin, again(part_of(batch, begin, size)))) {
      tell(&watched, FindingKind::batch_dependent, begin + changed->query,
           fmt::format("{}: as query {} of {}", changed->detail, changed->query + 1, size));
    }
  }

  // Vectorised code may round a measure otherwise at the end of a batch: decisions may not change.
  static Outputs<Real> verdicts_alone(Outputs<Real> said) {
    said.measures.clear();
    return said;
  }

  void tell(Watched* watched, FindingKind kind, std::size_t query, std::string detail) {
    if (watched == nullptr || (kind == FindingKind::inconsistent && is_told_)) return;
    is_told_ |= kind == FindingKind::inconsistent;
    watched->findings.push_back({kind, query, std::move(detail)});
  }

  const std::shared_ptr<Callable> callable_;
  bool is_first_ = true, is_told_ = false;
  int told_raised_ = 0;
};

template <class Real>
Implementation<Real> implementation_of(const std::shared_ptr<Callable>& callable) {
  const auto asked = std::make_shared<AskedFunction<Real>>(callable);
  Implementation<Real> made;
  made.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) { asked->ask(batch, out, nullptr, nullptr); };
  made.supervised = [=](const QueryColumns<Real>& batch, Verdict* out, Answers<Real>& answers, Watched& watched) {
    asked->ask(batch, out, &answers, &watched);
  };
  made.timed = [=](const QueryColumns<Real>& batch, Verdict* out) {
    Stopwatch watch;
    asked->ask(batch, out, nullptr, nullptr);
    return watch.lap();
  };
  const auto all = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    std::vector<Verdict> verdicts(batch.size);
    asked->ask(batch, verdicts.data(), &out, nullptr);
  };
  if (callable->shown().has_bits) made.explain = all;
  if (callable->shown().measure_count != 0) made.measure = all;
  return made;
}

}  // namespace

Kernel kernel_of(const std::shared_ptr<Callable>& callable, const KernelClaims& claims) {
  Kernel kernel = claimed_kernel(claims, callable->shown());
  kernel.summary = "a function of Python";
  for (const Precision precision : callable->shown().precisions) {
    if (precision == Precision::binary32)
      kernel.binary32 = [=](std::string_view) { return implementation_of<float>(callable); };
    else kernel.binary64 = [=](std::string_view) { return implementation_of<double>(callable); };
  }
  return kernel;
}

}  // namespace axiscert::python
