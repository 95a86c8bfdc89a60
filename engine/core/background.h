/// Work that others may go before: the interface, and a loop that must not be late.
#pragma once

namespace trocar {

/// The calling thread, and those that it starts from now on, give way to all others of the program. Where the system
/// knows no priority of threads nothing happens.
void give_way();

}  // namespace trocar
