; nothing moves
M30
