// linear_program.cpp -- nothing here needs it (circle_bounds.cpp).
