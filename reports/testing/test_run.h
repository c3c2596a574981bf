// For tests: the stored record, and run folders that are removed afterwards.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "kernel/base/error.h"
#include "fuzz/text/json.h"
#include "kernel/base/temporary_folder.h"
#include "reports/formats/format.h"
#include "reports/formats/render.h"

namespace axiscert {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  EXPECT_TRUE(in) << path;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// testdata/record.json: `published` with flips on `tangent`, none on `lattice` and `mesh/a|b.obj`; `<script>`, which
// shows only verdicts, with flips on both of its families. Tolerance for plane.radius, requirement `logic`.
inline Json stored_record() { return Json::parse(text_of(SOURCE_FOLDER "/reports/testdata/record.json")); }
// The same whose kernel, family, mesh and witness carry `name`.
inline Json named(const std::string& name) {
  std::string text = stored_record().dump();
  for (const std::string old : {"<script>", "a|b.obj"}) {
    const std::string quoted = Json(name).dump();
    const std::string replacement = quoted.substr(1, quoted.size() - 2);
    for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + replacement.size())) {
      text.replace(at, old.size(), replacement);
    }
  }
  return Json::parse(text);
}
inline Json stored_run_info() { return Json::parse(text_of(SOURCE_FOLDER "/reports/testdata/run.json")); }
// The counts of `published` on `tangent`.
inline Json& tangent_counts(Json& record) { return record["kernels"][0]["families"]["tangent"]; }

class TestFolder : public TemporaryFolder {
 public:
  TestFolder() = default;
  explicit TestFolder(const Json& record) { write("record.json", record.dump()); }

  std::string read(const std::string& file) const { return text_of(path() / file); }

  // The message of the Error that rendering throws; empty where it succeeds.
  std::string rendering_error() const {
    try {
      render_reports(path());
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
};

// One part of a page's data, decoded as a browser does it.
inline Json page_part(const std::string& html, const std::string& id) {
  const std::string open = "<script type=\"text/plain\" id=\"" + id + "\">";
  const std::size_t begin = html.find(open) + open.size();
  const std::string text = html.substr(begin, html.find("</script>", begin) - begin);
  std::string deflated(text.size(), '\0');
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(deflated.data()),
                                   reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  EXPECT_GT(size, 0);
  std::string json(1 << 20, '\0');
  for (;; json.resize(2 * json.size())) {
    uLongf length = json.size();
    // The bytes of base64's padding come after the end, which zlib finds by itself.
    const int outcome = uncompress(reinterpret_cast<Bytef*>(json.data()), &length,
                                   reinterpret_cast<const Bytef*>(deflated.data()), static_cast<uLong>(size));
    if (outcome == Z_BUF_ERROR && json.size() < std::size_t{1} << 30) continue;
    EXPECT_EQ(outcome, Z_OK);
    json.resize(length);
    return Json::parse(json);
  }
}

// The whole data of a page, as its scripts have it.
inline Json page_data(const std::string& html) {
  Json data = page_part(html, "data");
  data["witnesses"] = page_part(html, "witness-data");
  return data;
}

inline std::size_t occurrences(const std::string& text, const std::string& piece) {
  std::size_t n = 0;
  for (std::size_t at = text.find(piece); at != text.npos; at = text.find(piece, at + piece.size())) ++n;
  return n;
}

}  // namespace axiscert
