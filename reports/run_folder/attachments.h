// Files that other commands wrote into a run's folder: maps, bounds, searches, instruments.
#pragma once

#include <filesystem>

#include "fuzz/text/json_fwd.h"

namespace axiscert {

// One member for each kind, null where the folder has none, reduced to what the page shows. A file needs to have only
// the members that are read; the rest is ignored.
//   maps      maps/index.json: {"legend": [{"class", "colour", "meaning"}], "maps": [{"name", "kernel", "precision",
//             "kind", "along", "across", "command", "witness", "pictures": [{"level", "name", "file", "counts"}]}]}, as
//             `axiscert map` writes it; the pictures are next to it
//   proofs    proofs.json: {"comparisons": [{"name", "formulae"?, "precision"?, "status"?, "proved_u"?, "attained_u"?,
//             "file"?}], "checkers"?}
//   mutation  mutation.json: {"mutants": [{"id", "caught": null or {"family", "queries"}, "equivalent"}]}
//   search, ladder, precision, league: as those commands write them with --out
// Pictures are included as data URLs while there is room for them in `image_bytes`, those of verdicts and axes before
// those of comparisons; of the others only the file's name is kept. Throws Error where a file is not JSON or does not
// have the form that its reader needs.
Json attachments(const std::filesystem::path& folder, std::size_t image_bytes);

}  // namespace axiscert
