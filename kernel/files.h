// Whole files in and out: read at once, written under a temporary name and then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace suture {

/// All bytes of a file. \throw InvalidInput if it is missing, a folder, or cannot be read
std::string read_file(const std::filesystem::path& path);

/// Puts `bytes` at `path` whole or not at all: they go to a temporary name in the same folder,
/// which is then renamed; on failure the temporary file is removed and what was at `path` stays.
/// A symbolic link stays and what it names is replaced; a device or pipe is written to as it is.
/// \throw InvalidInput if that cannot be done
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace suture
