#pragma once

namespace forge {

/// Returns `time` - `now` (both s on one clock) in s, rounded to 1 us.
double fromNow(double time, double now);

}  // namespace forge
