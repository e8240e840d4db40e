// SPDX-FileCopyrightText: the armcal authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "armcal/io/session_file.h"

namespace armcal {

/// The text of a *.session.toml that `read_session_file` reads back as the same session. Paths are
/// written relative to `session.file`. What may be said about a table (units, column names) is not
/// written: the tables of observation_writer.h need none of it but `keep_duplicates` and
/// `keep_zero_points`.
[[nodiscard]] std::string session_text(const Session& session, const std::string& note = {});

}  // namespace armcal
