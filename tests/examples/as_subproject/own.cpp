// A parent project's own program, which names headers as users of the installed library do.
#include <suture/surgery/tracker.h>

int main() { return suture::TrackerOptions{}.depth == 1 ? 0 : 1; }
