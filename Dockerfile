# The program with all that it needs, on Debian: docker build -t simbad-sonar . && docker run --rm simbad-sonar run angle
# A test runs these steps in a bare Debian root (build-config/dockerfile-test).
FROM debian:bookworm-slim
COPY . /opt/simbad-sonar
WORKDIR /opt/simbad-sonar
# The launcher installs what it lacks, and builds.
RUN ./simbad --version
RUN rm -rf /var/lib/apt/lists/*
ENTRYPOINT ["/opt/simbad-sonar/simbad"]
CMD ["--help"]
