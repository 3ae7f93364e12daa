// The study's table as a CSV file, a row a run: written whole, read back to resume.
#pragma once

#include <filesystem>

#include "sims/study/table/row.h"

namespace suture::sims {

/// CSV (RFC 4180) with a heading; columns are the same for all rows of a study.
std::string to_csv(const std::vector<Row>& rows);

/// \throw InvalidInput with file and line for what to_csv does not write
std::vector<Row> read_csv(const std::filesystem::path& file);

/// FNV-1a, for telling apart what should be the same; not against those who want a collision.
std::string fingerprint(std::string_view bytes);
std::string fingerprint(const Triangles& surface);

}  // namespace suture::sims
