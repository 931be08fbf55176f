#pragma once
#include "orchestrator/app/command_line.h"

namespace millwear::orchestrator {

/// Each carries out one verb and prints its result to standard output. They throw Failures and
/// Interrupted.
void check_verb(const Command& command);
void mesh_verb(const Command& command);
void deck_verb(const Command& command);
void run_verb(const Command& command);
void status_verb(const Command& command);
void report_verb(const Command& command);
void wear_verb(const Command& command);
void import_verb(const Command& command);
void compare_verb(const Command& command);
void calibrate_verb(const Command& command);
void tune_verb(const Command& command);
void postprocess_verb(const Command& command);

}  // namespace millwear::orchestrator
