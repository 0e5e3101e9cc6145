//! One connection: as much of HTTP/1.1 as a browser needs to load a page.

use super::address::{Found, Site, media_type};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// An idle connection is closed after this time.
const PATIENCE: Duration = Duration::from_secs(30);
/// Longest request head that is read, in bytes.
const LONGEST_HEAD: u64 = 32 * 1024;

/// What we need to know of a request.
#[derive(Debug, PartialEq)]
struct Request {
    method: String,
    target: String,
    keep: bool,
}

/// Answers the requests of a connection, one after the other, until it is closed.
pub fn serve(stream: TcpStream, site: &Site) -> io::Result<()> {
    stream.set_read_timeout(Some(PATIENCE))?;
    stream.set_nodelay(true)?;
    let mut reader = BufReader::new(stream.try_clone()?);
    let mut writer = stream;
    while let Some(request) = read(&mut reader)? {
        answer(&mut writer, &request, site)?;
        if !request.keep {
            break;
        }
    }
    Ok(())
}

/// Reads a request's head; none at the end of the connection.
fn read(reader: &mut impl BufRead) -> io::Result<Option<Request>> {
    let mut head = reader.take(LONGEST_HEAD);
    let mut line = String::new();
    if head.read_line(&mut line)? == 0 {
        return Ok(None);
    }
    let malformed = || io::Error::new(io::ErrorKind::InvalidData, "not a request");
    let mut words = line.split_ascii_whitespace();
    let (Some(method), Some(target), Some(version)) = (words.next(), words.next(), words.next()) else {
        return Err(malformed());
    };
    let mut request =
        Request { method: method.to_owned(), target: target.to_owned(), keep: version == "HTTP/1.1" };
    loop {
        let mut line = String::new();
        if head.read_line(&mut line)? == 0 {
            return Err(malformed());
        }
        let line = line.trim_end().to_ascii_lowercase();
        if line.is_empty() {
            return Ok(Some(request));
        }
        if let Some((name, value)) = line.split_once(':') {
            let value = value.trim();
            // A request with a body is none of ours: its bytes would be taken for the next request.
            let body = (name == "content-length" && value != "0") || name == "transfer-encoding";
            request.keep &= !(body || (name == "connection" && value == "close"));
        }
    }
}

fn answer(writer: &mut impl Write, request: &Request, site: &Site) -> io::Result<()> {
    let plain = "text/plain; charset=utf-8";
    if request.method != "GET" && request.method != "HEAD" {
        return send(
            writer,
            request,
            "405 Method Not Allowed",
            plain,
            "Allow: GET, HEAD\r\n",
            b"only GET and HEAD\n",
        );
    }
    match site.look_up(&request.target) {
        Found::File(path) => match std::fs::read(&path) {
            Ok(content) => send(writer, request, "200 OK", media_type(&path), "", &content),
            Err(_) => send(writer, request, "404 Not Found", plain, "", b"not readable\n"),
        },
        Found::Elsewhere(address) => {
            send(writer, request, "302 Found", plain, &format!("Location: {address}\r\n"), b"elsewhere\n")
        }
        Found::Nothing => send(writer, request, "404 Not Found", plain, "", b"not found\n"),
        Found::Refused => send(writer, request, "400 Bad Request", plain, "", b"refused\n"),
    }
}

/// Writes an answer. Nothing is kept by the browser: a developer who reloads wants what is on disk.
fn send(
    writer: &mut impl Write,
    request: &Request,
    status: &str,
    media: &str,
    extra: &str,
    content: &[u8],
) -> io::Result<()> {
    let connection = if request.keep { "keep-alive" } else { "close" };
    let mut answer = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {media}\r\nContent-Length: {}\r\nCache-Control: no-store\r\n\
         Access-Control-Allow-Origin: *\r\nX-Content-Type-Options: nosniff\r\nConnection: {connection}\r\n{extra}\r\n",
        content.len()
    )
    .into_bytes();
    if request.method != "HEAD" {
        answer.extend_from_slice(content);
    }
    writer.write_all(&answer)?;
    writer.flush()
}

#[cfg(test)]
mod tests {
    use super::{Request, answer, read};
    use crate::serve::address::{Prefix, Site};
    use std::io::Cursor;

    fn request(text: &str) -> std::io::Result<Option<Request>> {
        read(&mut Cursor::new(text.as_bytes()))
    }

    fn reply(method: &str, target: &str) -> String {
        // The package's own folder holds a file that is certainly there.
        let folder = std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR"));
        let site = Site { folder, prefix: Prefix::new("/").unwrap() };
        let request = Request { method: method.to_owned(), target: target.to_owned(), keep: true };
        let mut written = Vec::new();
        answer(&mut written, &request, &site).unwrap();
        String::from_utf8(written).unwrap()
    }

    #[test]
    fn requests_are_read_and_connections_kept() {
        let get = |keep| Some(Request { method: "GET".to_owned(), target: "/a?b".to_owned(), keep });
        assert_eq!(request("GET /a?b HTTP/1.1\r\nHost: x\r\n\r\n").unwrap(), get(true));
        assert_eq!(request("GET /a?b HTTP/1.1\r\nConnection: Close\r\n\r\n").unwrap(), get(false));
        assert_eq!(request("GET /a?b HTTP/1.1\r\nContent-Length: 3\r\n\r\nabc").unwrap(), get(false));
        assert_eq!(request("GET /a?b HTTP/1.0\r\n\r\n").unwrap(), get(false));
        assert_eq!(request("").unwrap(), None);
    }

    #[test]
    fn what_is_no_request_or_too_long_is_an_error() {
        assert!(request("GET\r\n\r\n").is_err());
        assert!(request("GET / HTTP/1.1\r\nHost: x\r\n").is_err());
        assert!(request(&format!("GET / HTTP/1.1\r\nX: {}\r\n\r\n", "y".repeat(40_000))).is_err());
    }

    #[test]
    fn answers_carry_length_and_forbid_keeping() {
        let get = reply("GET", "/Cargo.toml");
        let (head, body) = get.split_once("\r\n\r\n").unwrap();
        assert!(head.starts_with("HTTP/1.1 200 OK\r\n"));
        assert!(head.contains(&format!("Content-Length: {}\r\n", body.len())));
        assert!(head.contains("Cache-Control: no-store") && body.contains("name = \"xtask\""));
        assert!(reply("HEAD", "/Cargo.toml").ends_with("\r\n\r\n"));
        assert!(reply("POST", "/Cargo.toml").starts_with("HTTP/1.1 405 "));
        assert!(reply("GET", "/none").starts_with("HTTP/1.1 404 "));
        assert!(reply("GET", "/../Cargo.toml").starts_with("HTTP/1.1 400 "));
        assert!(reply("GET", "/src").contains("\r\nLocation: /src/\r\n"));
    }
}
