// The options that several commands share: how each is spelled, what it accepts, and what it says to anything else.
#pragma once

#include "core/render/render.hpp"
#include "tools/zerkalo/frame.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace zerkalo {

/// `; did you mean "..."?`, or nothing when no candidate is near.
std::string suggestion(std::string_view word, const std::vector<std::string_view>& candidates);

/// Accepts whole numbers min..max in decimal digits and nothing else.
CLI::Validator whole_number(std::int64_t min, std::int64_t max);

/// Accepts finite numbers above 0 in decimal digits, with an exponent or without, and nothing else.
CLI::Validator positive_number();

/// Accepts one of `names`; the message lists them.
CLI::Validator one_of(const std::vector<std::string_view>& names);

/// --size WxH, sides 1..kMaxImageSide and at most kMaxPixels in all.
void add_size_option(CLI::App& command, Settings& settings);

/// --samples, --antialias, --depth-limit and --exact-plan.
void add_quality_options(CLI::App& command, Settings& settings);

/// --number NAME
void add_number_option(CLI::App& command, Number& number);

/// --isa NAME. Whether this CPU has it is asked later: see chosen_isa().
void add_isa_option(CLI::App& command, std::optional<Isa>& isa);

/// --threads N; the default is every hardware thread that this process may use.
void add_threads_option(CLI::App& command, int& threads);

/// --json
void add_json_option(CLI::App& command, bool& json);

/// The number of hardware threads that this process may use, at least 1.
int hardware_threads();

/// The instruction sets that this program has and this CPU can run, as "scalar, sse2, ...".
std::string available_isas();

/// The wanted instruction set, or the widest one. Throws Failure(no_device) when this CPU cannot run it.
Isa chosen_isa(const std::optional<Isa>& wanted);

}  // namespace zerkalo
