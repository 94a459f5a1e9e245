# The Windows program: recursion and large programs get the stack that threads have on Linux.
target_link_options(feedscope PRIVATE -Wl,--stack,8388608)
