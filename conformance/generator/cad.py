def cases(add): pass
