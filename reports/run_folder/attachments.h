// What other commands wrote into a run's folder: maps, bounds, searches, instruments.
#pragma once

#include <filesystem>

#include "fuzz/files/json.h"

namespace axiscert {

// One member a kind, null where the folder has none, reduced to what the page shows. Of each file no more is asked than
// the members that are read; the rest is ignored.
//   maps      maps/index.json: {"legend": [{"class", "colour", "meaning"}], "maps": [{"name", "kernel", "precision",
//             "kind", "along", "across", "command", "witness", "pictures": [{"level", "name", "file", "counts"}]}]}, as
//             `axiscert map` writes it; the pictures lie beside it
//   proofs    proofs.json: {"comparisons": [{"name", "formulae"?, "precision"?, "status"?, "proved_u"?, "attained_u"?,
//             "file"?}], "checkers"?}
//   mutation  mutation.json: {"mutants": [{"id", "caught": null or {"family", "queries"}, "equivalent"}]}
//   search, ladder, precision, league: as those commands write them with --out
// Pictures go in as data URLs while there is room for them in `image_bytes`, those of verdicts and axes before those of
// comparisons; the others keep their file's name alone.
// Throws Error where a file is no JSON or has not the form that its reader needs.
Json attachments(const std::filesystem::path& folder, std::size_t image_bytes);

// The files of the folder that the page can point to: [{"name", "meaning"}].
Json raw_files(const std::filesystem::path& folder);

}  // namespace axiscert
