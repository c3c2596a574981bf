// Every entry of the corpus as a test of its own, and the messages about a corpus that is not valid.
#include "fuzz/files/corpus.h"
#include "kernel/query.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <fstream>

#include "exact/moving_sphere/motion_distance.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "kernel/base/folders.h"
#include "kernel/queries_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Tests are listed with it; without it, with the bytes of the entry.
static void PrintTo(const CorpusEntry& entry, std::ostream* out) { *out << entry.stored.id; }

namespace {

// Empty if the corpus cannot be read, which Corpus.CanBeRead then reports.
std::vector<CorpusEntry> entries_or_none() {
  try {
    return read_corpus(SOURCE_FOLDER "/fuzz/corpus");
  } catch (const Error&) {
    return {};
  }
}

TEST(Corpus, CanBeRead) {
  std::vector<CorpusEntry> entries;
  ASSERT_NO_THROW(entries = read_corpus(SOURCE_FOLDER "/fuzz/corpus"));
  EXPECT_GE(entries.size(), 30u);
  for (const char* kind : {"report", "made", "address", "search"}) {
    EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [&](const CorpusEntry& e) {
      return e.provenance.kind == kind;
    })) << kind;
  }
}

class CorpusEntryTest : public testing::TestWithParam<CorpusEntry> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CorpusEntryTest);
INSTANTIATE_TEST_SUITE_P(Corpus, CorpusEntryTest, testing::ValuesIn(entries_or_none()), [](const auto& info) {
  std::string name = info.param.stored.id;
  for (char& c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return name;
});

// The squared distance by the walk over the features in rationals, which shares nothing with CGAL.
template <class Real>
Rational walked(const Query<Real>& q) {
  const auto centred = centred_as<Rational>(q, [](Real x) { return exact(x); });
  const auto found = walked_squared_distance(centred, Rational(0), Rational(1),
                                             [](const Rational& x, const Rational& y) { return cmp(x, y); });
  return found.numerator / found.denominator;
}

Numbers<double> wide_numbers(const StoredQuery& stored) {
  return std::visit([](const auto& q) { return in_doubles(q); }, stored.numbers);
}

TEST_P(CorpusEntryTest, HasTheseExactAnswers) {
  const CorpusEntry& entry = GetParam();
  SCOPED_TRACE(entry.file + ":" + std::to_string(entry.stored.line));
  const ExactAnswers& expected = entry.expected;
  EXPECT_EQ(exact_answers(entry.stored), expected);
  if (expected.verdict == Verdict::invalid) return;
  if (entry.stored.predicate == &moving_sphere_predicate()) {
    // Each oracle separately: our own rationals, and CGAL's distance of two triangles.
    const Numbers<double> q = wide_numbers(entry.stored);
    const MovingQuery<double> motion = MovingSphere::problem<double>([&](std::size_t k) { return q[k]; });
    // A point that crosses the face is at distance 0 then, which is not touching.
    const bool at_radius = expected.touching || motion.r == 0;
    const int order = expected.verdict == Verdict::separated ? 1 : at_radius ? 0 : -1;
    const Rational r(motion.r), squared = moving_sphere::least_distance(motion).squared;
    EXPECT_EQ(moving_sphere::swept_distance_order(motion), order) << "CGAL";
    EXPECT_EQ(sgn(Rational(squared - r * r)), order) << "feature by feature";
    return;
  }
  if (entry.stored.predicate != &sphere_triangle_predicate())
    return;  // exact_answers has compared the oracles of two boxes
  std::visit(
      [&](const auto& q) {
        // Checks each oracle separately.
        const int order = expected.verdict == Verdict::separated ? 1 : expected.touching ? 0 : -1;
        EXPECT_EQ(distance_order(q), order) << "CGAL";
        const SecondOpinion mpfr = second_opinion(q);
        EXPECT_EQ(mpfr.distance_order, order) << "MPFR";
        EXPECT_EQ(mpfr.strict, *expected.comparisons) << "MPFR";
        EXPECT_EQ(mpfr.ties, *expected.ties) << "MPFR";
        EXPECT_EQ(walked(q), *expected.squared_distance) << "the walk over the features";
      },
      sphere_triangle_query(entry.stored));
}

TEST_P(CorpusEntryTest, IsWrittenAsItIsRead) {
  const CorpusEntry& entry = GetParam();
  std::ifstream file(entry.file);
  std::string line;
  for (std::size_t n = 0; n < entry.stored.line; ++n) std::getline(file, line);
  EXPECT_EQ(corpus_line(entry), line);
}

// A folder with one file that consists of these lines.
class CorpusFolder {
 public:
  explicit CorpusFolder(const std::string& text) { folder_.write("x.jsonl", text); }
  std::string error() const {
    try {
      read_corpus(folder_.path().string());
    } catch (const Error& wrong) {
      return wrong.what();
    }
    return "";
  }

 private:
  const TemporaryFolder folder_;
};

CorpusEntry touching_entry() {
  const Query<float> q = {{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {0, 0, 0}, 1};
  StoredQuery stored{"touching", Precision::binary32, q, &sphere_triangle_predicate(), 0, 1};
  return {stored, {"made", "by hand", ""}, "", exact_answers(stored), "x.jsonl"};
}

TEST(CorpusFiles, AnEntryComesBack) {
  const std::string line = corpus_line(touching_entry());
  EXPECT_EQ(CorpusFolder(line + "\r\n\n").error(), "");
}

TEST(CorpusFiles, ABadOneIsNamedByFileLineAndField) {
  const std::string good = corpus_line(touching_entry());
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    text.replace(text.find(from), from.size(), to);
    return good + "\n" + text;
  };
  const auto expect = [](const std::string& text, std::initializer_list<const char*> says) {
    const std::string error = CorpusFolder(text).error();
    for (const char* part : says) EXPECT_NE(error.find(part), error.npos) << part << " in: " << error;
  };
  expect("", {"x.jsonl", "no queries"});
  expect(with("\"id\":\"touching\"", "\"id\":\"other\""), {"x.jsonl:2:", "symmetry", "x.jsonl:1"});
  expect(with("0x1p+0", "0x1p+1"), {"x.jsonl:2:", "'id'", "x.jsonl:1"});
  expect(with("\"made\"", "\"nowhere\""), {"x.jsonl:2:", "'kind'", "nowhere", "report"});
  expect(with("\"by hand\"", "\"\""), {"x.jsonl:2:", "'where'"});
  expect(with("\"provenance\"", "\"provenence\""), {"x.jsonl:2:", "'provenance'", "missing"});
  expect(with("\"made\"", "\"report\""), {"x.jsonl:2:", "'about'", "static"});
  expect(with("\"verdict\":\"contact\"", "\"verdict\":\"yes\""), {"x.jsonl:2:", "'verdict'", "separated"});
  expect(with("\"touching\":true", "\"touching\":1"), {"x.jsonl:2:", "'touching'"});
  expect(with("\"1/1\"", "\"1/0\""), {"x.jsonl:2:", "'squared_distance'"});
  expect(with("\"ties\":\"", "\"ties\":\"0"), {"x.jsonl:2:", "'ties'", "16"});
  expect("{\"id\":", {"x.jsonl:1:"});
  EXPECT_THROW(read_corpus("/nonexistent"), Error);
}

TEST(CorpusSource, HasEveryQueryInItsPrecision) {
  const auto source = corpus_source(SOURCE_FOLDER "/fuzz/corpus", sphere_triangle_predicate());
  EXPECT_EQ(source->name(), "corpus");
  std::size_t n32 = 0, n64 = 0;
  for (const CorpusEntry& entry : entries_or_none()) {
    if (entry.stored.predicate != &sphere_triangle_predicate()) continue;
    if (entry.stored.precision == Precision::binary32) {
      const Query<float> q = source->make<float>(1, n32++);
      expect_same_bits(q, sphere_triangle_query_in<float>(entry.stored));
    } else {
      const Query<double> q = source->make<double>(1, n64++);
      expect_same_bits(q, sphere_triangle_query_in<double>(entry.stored));
    }
  }
  EXPECT_EQ(source->fixed_size(Precision::binary32), n32);
  EXPECT_EQ(source->fixed_size(Precision::binary64), n64);
  EXPECT_EQ(source->address_name(), "corpus-" + source->file()->sha256);
}

TEST(CorpusSource, HasTheQueriesOfOneEntryOfAPredicate) {
  for (const Predicate* predicate : predicates()) {
    std::size_t all = 0;
    for (std::size_t entry = 0; entry < predicate->entries.size(); ++entry) {
      std::size_t count = 0;
      for (const CorpusEntry& kept : entries_or_none()) {
        count += kept.stored.predicate == predicate && kept.stored.entry == entry ? 1 : 0;
      }
      all += count;
      if (count == 0) {
        EXPECT_THAT([&] { corpus_source(SOURCE_FOLDER "/fuzz/corpus", *predicate, entry); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr(std::string(predicate->entries[entry].name))));
        continue;
      }
      const auto source = corpus_source(SOURCE_FOLDER "/fuzz/corpus", *predicate, entry);
      EXPECT_EQ(*source->fixed_size(Precision::binary32) + *source->fixed_size(Precision::binary64), count)
          << predicate->id << ", " << predicate->entries[entry].name;
    }
    if (predicate->entries.size() > 1) {
      EXPECT_GT(all, 1u) << predicate->id;
    }
  }
}

}  // namespace
}  // namespace axiscert
