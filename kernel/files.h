// Whole files in and out: a file is read at once, and written under another name and then renamed.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace suture {

/// Returns all bytes of a file. \throw InvalidInput if it is missing, is a folder, or cannot be
/// read
std::string read_file(const std::filesystem::path& path);

/// Puts `bytes` at `path` whole or not at all. They go to a temporary file in the same folder,
/// which is then renamed; on failure that file is removed, and the one at `path` stays. A symbolic
/// link stays and the file that it names is replaced; a device or pipe is written to directly.
/// \throw InvalidInput if that cannot be done
void write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace suture
