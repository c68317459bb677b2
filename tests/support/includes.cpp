// Nothing of its own: its target compiles the includes that the tests share.
