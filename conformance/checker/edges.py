def read(data): pass
