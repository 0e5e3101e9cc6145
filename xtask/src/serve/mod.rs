//! `cargo xtask serve`: the static folder on a loopback port.
//!
//! Written on the standard library: a file server for one developer needs a hundred lines, and a crate for it would
//! bring more code than that to everyone who builds the project.

mod address;
mod connection;

pub use address::Prefix;

use crate::command::Options;
use crate::{Failure, build, place};
use std::net::{Ipv4Addr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;

/// Tried first when no port is asked for.
const FIRST_PORT: u16 = 8080;
/// How many ports from there on are tried.
const PORTS_TRIED: u16 = 100;

/// What is served, and where.
pub struct Server {
    listener: TcpListener,
    site: Arc<address::Site>,
}

impl Server {
    /// Takes a port: the one asked for, or else the first free one from 8080.
    pub fn bind(folder: PathBuf, prefix: Prefix, port: Option<u16>) -> Result<Self, Failure> {
        let ports = port.map_or(FIRST_PORT..=FIRST_PORT + PORTS_TRIED, |port| port..=port);
        let mut refused = String::new();
        for port in ports {
            match TcpListener::bind((Ipv4Addr::LOCALHOST, port)) {
                Ok(listener) => {
                    return Ok(Self { listener, site: Arc::new(address::Site { folder, prefix }) });
                }
                Err(error) => refused = format!("127.0.0.1:{port} cannot be had: {error}"),
            }
        }
        Err(Failure::invalid("the port", refused))
    }

    /// The address to open.
    pub fn address(&self) -> String {
        let port = self.listener.local_addr().map_or(0, |address| address.port());
        format!("http://127.0.0.1:{port}{}", self.site.prefix.as_str())
    }

    /// Serves in a thread of its own, as long as the process lives; answers the address.
    pub fn in_background(self) -> String {
        let address = self.address();
        std::thread::spawn(move || self.run());
        address
    }

    /// Serves until the process ends, each connection in a thread of its own.
    pub fn run(self) {
        for stream in self.listener.incoming().flatten() {
            let site = Arc::clone(&self.site);
            // A browser that goes away in the middle of an answer is no news.
            std::thread::spawn(move || connection::serve(stream, &site));
        }
    }
}

/// The task: builds and serves.
pub fn serve(options: &Options) -> Result<(), Failure> {
    let refuse = |given: &str| Failure::Usage { given: given.to_owned(), help: crate::HELP };
    let port = match options.value("--port") {
        Some(given) => Some(given.parse().map_err(|_| refuse(given))?),
        None => None,
    };
    let prefix = options.value("--prefix").unwrap_or("/");
    let prefix = Prefix::new(prefix).ok_or_else(|| refuse(prefix))?;
    let folder = place::root().join("dist");
    if !options.flag("--no-build") {
        build::build(&folder)?.report();
    }
    let server = Server::bind(folder, prefix, port)?;
    println!("serving at {}  (Ctrl-C ends it)", server.address());
    server.run();
    Ok(())
}
