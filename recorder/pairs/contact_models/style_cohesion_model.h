// No cohesion model is compiled anew; LIGGGHTS wants the file.
