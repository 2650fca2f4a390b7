// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_STRATEGY_NAMES_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_STRATEGY_NAMES_H

#include "commands/commands.h"

// The names of the strategies in named_strategies.h, for those who need nothing else of them.
Arguments quintic_names();
Arguments septic_names();

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_BLENDS_STRATEGY_NAMES_H
