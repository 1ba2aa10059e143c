module tdsp.example

go 1.19
