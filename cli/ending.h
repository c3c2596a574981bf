// How a command ends that was interrupted, or that could not write: what of its work is kept, and the command that goes
// on from there.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

namespace axiscert {
// The words of the command line after the program's name. From here on an interrupt, SIGINT or SIGTERM, ends the
// process at once, with a sentence and the status interrupted_code(). A limit on the size of files is a write that
// fails.
void begin_command(const std::vector<std::string>& words);

// From here on, the first interrupt sets the flag: work under way is finished and reported. The second one ends the
// process at once.
const std::atomic<bool>& watch_for_interrupts();
// 130 after SIGINT, 143 after SIGTERM; 130 where there was none.
int interrupted_code();

// The command as it was given, in a form that a shell reads, with the option where it is not among its words.
std::string own_command(std::string_view option = "");
// From here on it has this value of an option; an empty one leaves the option out.
void set_own_option(std::string_view option, const std::string& value);
// From here on work is kept: `kept` says what, and where. `command` goes on from there.
void keep_work(const std::string& kept, const std::string& command);
// Nothing is kept to go on from: `why`, for example "a run without --plan keeps no journal".
void keep_nothing(const std::string& why);
// Says nothing of interrupts: another process does.
void leave_ending_to_another();

// Prints what is kept, then in the last line the command that goes on, or begins again.
void print_how_to_go_on();
// The same after an error, where work is kept.
void print_what_is_kept();
// Flushes standard output. Throws Unwritable where a reader did not get all of it.
void finish_output();

}  // namespace axiscert
