# Makes up the wall contacts of 4 s of a 1 m mill with 12 lifters: awk -f make_contacts.awk
function random() { seed = seed * 16807 % 2147483647; return seed / 2147483647 }
BEGIN {
  seed = 2006
  pi = 3.14159265358979; rows = 12; radius = 0.465; height = 0.04; half_top = 0.02; tangent = 0.365
  foot = half_top + height * tangent
  print "time_s,particle,x_m,y_m,z_m,normal_force_n,slip_speed_m_per_s"
  for (sample = 1; sample <= 400; ++sample) {
    for (contact = 0; contact < 12; ++contact) {
      # A place (xi, eta) on a lifter or the plate beside it: most slip at the top of the leading face.
      place = random(); share = random()
      if (place < 0.4) { eta = height * share; xi = half_top + (height - eta) * tangent; slip = 0.1 + 0.7 * share * share }
      else if (place < 0.6) { eta = height; xi = half_top * (2 * share - 1); slip = 0.8 }
      else if (place < 0.65) { eta = height * share; xi = -half_top - (height - eta) * tangent; slip = 0.8 * share }
      else { beta = foot / radius + share * (2 * pi / rows - 2 * foot / radius)
             xi = radius * sin(beta); eta = radius * (1 - cos(beta)); slip = 0.1 }
      # The lifter is one that lies under the charge, between 10 degrees before and 110 after six o'clock.
      turned = 3.3 * 0.01 * sample
      row = int((pi / 18 * (11 - 12 * random()) - turned) / (2 * pi / rows) + 100 * rows)
      angle = turned + row * 2 * pi / rows
      x = -xi * cos(angle) + (eta - radius) * sin(angle)
      z = xi * sin(angle) + (eta - radius) * cos(angle)
      printf "%.2f,%d,%.6f,%.4f,%.6f,%.2f,%.3f\n", 0.01 * sample, 1 + int(1200 * random()), x,
        0.12 * random(), z, -25 * log(random()), slip
    }
  }
}
